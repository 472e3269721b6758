#pragma once

/// @file
/// A problem: bounds, objective, constraints, derivatives.

#include "src/core/problem.h"
