#pragma once

/// @file
/// One run of a solver on a problem, its record, and what the suite says of it.

#include "src/core/run.h"
#include "src/core/verdict.h"
