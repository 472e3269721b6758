#pragma once

/// @file
/// What is asked and judged, and the forms in which a solver is shown it.

#include "src/core/question.h"
