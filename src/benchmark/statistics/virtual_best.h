#pragma once

#include <cstddef>
#include <vector>

#include "src/benchmark/statistics/costs.h"

namespace ricochet {

/// The least cost of each problem: that of a virtual solver that always picks the best one present.
/// Infinite if none solved it. Throws std::invalid_argument for invalid costs.
std::vector<double> virtual_best(const Costs& costs);

/// The cost of using one solver for all problems instead of the best for each.
struct VirtualBestGap {
  std::size_t single_best;  ///< the solver with the least mean, the first of equals
  double mean_of_single_best;
  double mean_of_virtual_best;
};

/// The single best solver against the virtual best, by shifted geometric means with PAVER's shift
/// and floor (Lindauer, van Rijn and Kotthoff 2019, doi:10.1016/j.artint.2018.10.004, on the gap).
/// Charge a failed run what it spent: one infinite cost makes the mean infinite. Throws
/// std::invalid_argument as above.
VirtualBestGap virtual_best_gap(const Costs& costs);

}  // namespace ricochet
