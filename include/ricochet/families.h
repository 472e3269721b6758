#pragma once

/// @file
/// Every family of problems that there is.

#include "problems/families.h"
