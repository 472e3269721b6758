#pragma once

#include "ricochet/solver.h"

namespace ricochet {

/// "random-search": the start, then points uniform in the box until the evaluator refuses. It is
/// the baseline that any other solver should beat. It does not compare points itself, so it takes
/// any constraints.
Solver random_search();

}  // namespace ricochet
