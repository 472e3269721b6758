#pragma once

/// @file
/// All solvers.

#include "solvers/solvers.h"
