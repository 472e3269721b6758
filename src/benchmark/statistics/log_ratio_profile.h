#pragma once

#include <cstddef>
#include <vector>

namespace ricochet {

enum class SolvedBy { both, only_a, only_b, neither };

/// log2(cost of A / cost of B) on one problem: negative where A is cheaper.
struct LogRatio {
  std::size_t problem;
  double log2_ratio;
  SolvedBy solved_by;
};

/// The log-ratios of two solvers on all problems, in rising order (Morales 2002,
/// doi:10.1016/S0893-9659(01)00162-8, with the conventions of OptiProfiler,
/// https://www.optprof.com). If one solver failed, the bar is 1.1 times the largest ratio in favour
/// of the other; if both failed, there are two bars, the first and the last of all, one on each
/// side. If every ratio is 0, or there is none, 1 replaces the largest. A cost is > 0, and infinite
/// for a failure. Throws std::invalid_argument for other costs, or samples that are empty or differ
/// in length.
std::vector<LogRatio> log_ratio_profile(const std::vector<double>& costs_of_a,
                                        const std::vector<double>& costs_of_b);

}  // namespace ricochet
