#pragma once

/// @file
/// Every family of questions that there is.

#include "problems/families.h"
