#include "src/benchmark/statistics/virtual_best.h"

#include <algorithm>

#include "src/benchmark/statistics/shifted_geometric_mean.h"

namespace ricochet {

std::vector<double> virtual_best(const Costs& costs) {
  check_costs(costs);
  std::vector<double> best;
  for (const std::vector<double>& row : costs) {
    best.push_back(*std::min_element(row.begin(), row.end()));
  }
  return best;
}

VirtualBestGap virtual_best_gap(const Costs& costs) {
  const std::size_t solvers = check_costs(costs);
  std::vector<double> means;
  for (std::size_t solver = 0; solver < solvers; ++solver) {
    std::vector<double> own;
    for (const std::vector<double>& row : costs) own.push_back(row[solver]);
    means.push_back(shifted_geometric_mean(own));
  }
  const auto least = std::min_element(means.begin(), means.end());
  return {.single_best = static_cast<std::size_t>(least - means.begin()),
          .mean_of_single_best = *least,
          .mean_of_virtual_best = shifted_geometric_mean(virtual_best(costs))};
}

}  // namespace ricochet
