#pragma once

/// @file
/// Every solver that there is.

#include "solvers/solvers.h"
