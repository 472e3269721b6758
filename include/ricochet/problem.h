#pragma once

/// @file
/// What is asked of a solver: bounds, objective, constraints, derivatives.

#include "src/core/problem.h"
