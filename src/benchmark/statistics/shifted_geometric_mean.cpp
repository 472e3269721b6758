#include "src/benchmark/statistics/shifted_geometric_mean.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ricochet {

double shifted_geometric_mean(const std::vector<double>& costs, double shift, double floor) {
  if (costs.empty()) throw std::invalid_argument("shifted_geometric_mean: no costs");
  if (!(shift >= 0 && floor >= 0 && shift + floor > 0 && std::isfinite(shift + floor))) {
    throw std::invalid_argument("shifted_geometric_mean: shift and floor must be >= 0, one > 0");
  }
  double sum = 0;
  for (const double cost : costs) {
    if (!(cost >= 0)) throw std::invalid_argument("shifted_geometric_mean: a cost must be >= 0");
    sum += std::log(std::max(cost, floor) + shift);
  }
  return std::exp(sum / static_cast<double>(costs.size())) - shift;
}

}  // namespace ricochet
