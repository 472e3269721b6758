#pragma once

#include <cstddef>

#include "src/benchmark/analysis/comparison.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

/// What separates the entries that solve a problem from those that do not, with the largest budget:
/// `entries`, `solving` (in at least half of their runs), and `separates`, `those` and `others`: a
/// property of entries, and the success rates with and without it. The property is a formulation,
/// needing gradients, or being stochastic: that of least p-value of the rank-sum test of the
/// entries' success rates, if it is below 5 % after Holm's correction over the properties; else
/// null. Entries of one solver are alike: the test takes them as independent.
report::Json separation_data(const Comparison& comparison, std::size_t problem);

}  // namespace ricochet::studies::comparison
