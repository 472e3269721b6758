#pragma once

#include "src/benchmark/comparison/group.h"

namespace ricochet::studies::comparison {

/// Effect of the formulation on a solver: for every solver that takes several formulations, the
/// success rate in each with the largest budget, by family.
report::Json formulation_data(const Comparison& comparison, const std::vector<Group>& groups);

/// Surrogate bias: the distance from the optimum of the surrogate to the best point, for every
/// smoothing parameter that is used. A solver that converges to the surrogate's optimum cannot come
/// closer.
report::Json ceiling_data(const Comparison& comparison, const std::vector<Group>& groups);

}  // namespace ricochet::studies::comparison
