#pragma once

/// @file
/// Collision counts over a range of speeds, and the fastest quiet speed.

#include "problems/carrier_track/counting/threshold.h"
