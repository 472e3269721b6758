#pragma once

/// @file
/// The interface of a solver.

#include "src/core/solver.h"
