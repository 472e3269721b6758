#pragma once

/// @file
/// Counts over the speeds, and the fastest quiet speed.

#include "problems/carrier_track/counting/threshold.h"
