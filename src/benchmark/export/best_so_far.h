#pragma once

#include <vector>

#include "src/benchmark/analysis/outcome.h"

namespace ricochet::exports {

/// Stands for the optimality gap until a feasible point is found, in formats that require a number.
/// An optimality gap of this size or more is left out as if not found.
inline constexpr double nothing_feasible = 1e30;

/// The best optimality gap of a run over its evaluations, as readers of other suites expect it: the
/// first row is of evaluation 1, the last of the run's last evaluation; evaluations rise; every
/// optimality gap except the last row's is below the one before; all are finite. A run that was
/// charged nothing has one row, of evaluation 1. Seconds are 0 if unknown.
std::vector<comparison::Step> best_so_far(const comparison::Outcome& outcome);

}  // namespace ricochet::exports
