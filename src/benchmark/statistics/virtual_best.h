#pragma once

#include <cstddef>
#include <vector>

#include "src/statistics/costs.h"

namespace ricochet {

/// The least cost of each question: that of a solver who always picks the right one of those there
/// are. Infinite where none solved it. Throws std::invalid_argument for costs that are none.
std::vector<double> virtual_best(const Costs& costs);

/// What is lost by using one solver for all questions.
struct VirtualBestGap {
  std::size_t single_best;  ///< the solver of the least mean, the first of equals
  double mean_of_single_best;
  double mean_of_virtual_best;
};

/// The single best solver against the virtual best, by shifted geometric means with PAVER's shift
/// and floor (Lindauer, van Rijn and Kotthoff 2019, doi:10.1016/j.artint.2018.10.004, on the gap).
/// A failed run is to be charged what it spent: with one that is infinite the mean is. Throws
/// std::invalid_argument as above.
VirtualBestGap virtual_best_gap(const Costs& costs);

}  // namespace ricochet
