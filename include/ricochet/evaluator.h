#pragma once

/// @file
/// Who counts, times and stops: all that a solver sees of a problem.

#include "src/core/evaluator.h"
