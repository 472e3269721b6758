#include "src/statistics/cost_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace ricochet {

CostComparison compare_costs(const std::vector<double>& costs_of_a,
                             const std::vector<double>& costs_of_b) {
  constexpr double tolerance = 1.1;
  if (costs_of_a.size() != costs_of_b.size()) {
    throw std::invalid_argument("compare_costs: costs of both solvers on the same questions");
  }
  CostComparison comparison;
  for (std::size_t k = 0; k < costs_of_a.size(); ++k) {
    const double a = costs_of_a[k];
    const double b = costs_of_b[k];
    if (!(a > 0 && b > 0)) throw std::invalid_argument("compare_costs: a cost must be > 0");
    if (std::isinf(a) && std::isinf(b)) {
      ++comparison.neither;
    } else if (std::max(a, b) <= tolerance * std::min(a, b)) {
      ++comparison.close;
    } else {
      ++(a < b ? comparison.better : comparison.worse);
    }
  }
  return comparison;
}

}  // namespace ricochet
