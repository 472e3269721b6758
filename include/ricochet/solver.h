#pragma once

/// @file
/// What a solver is.

#include "src/core/solver.h"
