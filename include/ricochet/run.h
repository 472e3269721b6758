#pragma once

/// @file
/// One run of a solver on a problem, its record, and its score.

#include "src/core/run.h"
#include "src/core/verdict.h"
