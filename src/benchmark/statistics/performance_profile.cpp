#include "src/benchmark/statistics/performance_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace ricochet {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

double ratio_of(double cost, double reference) {
  return std::isinf(cost) ? never : cost / reference;
}

}  // namespace

Costs performance_ratios(const Costs& costs) {
  check_costs(costs);
  Costs ratios = costs;
  for (std::vector<double>& row : ratios) {
    const double least = *std::min_element(row.begin(), row.end());
    for (double& cost : row) cost = ratio_of(cost, least);
  }
  return ratios;
}

Costs extended_performance_ratios(const Costs& costs) {
  if (check_costs(costs) < 2) {
    throw std::invalid_argument("extended_performance_ratios: two solvers are needed");
  }
  Costs ratios = costs;
  for (std::vector<double>& row : ratios) {
    std::vector<double> two(
        2);  // the least and the second least cost, which a winner is compared with
    std::partial_sort_copy(row.begin(), row.end(), two.begin(), two.end());
    for (double& cost : row) cost = ratio_of(cost, cost == two[0] ? two[1] : two[0]);
  }
  return ratios;
}

MeanShare performance_profile(const Costs& ratios, std::size_t solver, double ratio,
                              double confidence) {
  std::vector<double> within;
  for (const std::vector<double>& row : ratios) {
    if (solver >= row.size() || row.size() != ratios.front().size() || !(row[solver] >= 0)) {
      throw std::invalid_argument("performance_profile: ratios >= 0 of every solver are needed");
    }
    within.push_back(std::isfinite(row[solver]) && row[solver] <= ratio ? 1 : 0);
  }
  return mean_share(within, confidence);
}

}  // namespace ricochet
