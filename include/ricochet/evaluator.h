#pragma once

/// @file
/// The evaluator: a solver's view of a problem. It counts evaluations, measures time and stops the
/// run.

#include "src/core/evaluator.h"
