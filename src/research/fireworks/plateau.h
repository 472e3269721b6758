#pragma once

#include "ricochet/problem.h"
#include "src/report/json.h"

namespace ricochet::studies::fireworks {

/// Needle in a haystack: on [0, 1000] a target of width 1 that begins at `target`: 0 inside it and
/// 1 elsewhere.
Problem needle(double target);

/// The same target, with ceil(log2(1 + distance)) elsewhere: a staircase that leads to it.
Problem logarithmic_staircase(double target);

/// How often each member of the family, and random search, hits such a target within 1000
/// evaluations.
report::Json plateau_data(int runs);

}  // namespace ricochet::studies::fireworks
