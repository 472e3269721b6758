#include "src/analysis/statistics/profiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ricochet {

MeanShare empirical_distribution(const std::vector<std::vector<double>>& hitting_times, double t,
                                 const std::vector<std::string>& clusters) {
  std::vector<double> shares;
  for (const std::vector<double>& times : hitting_times) {
    if (times.empty() ||
        std::any_of(times.begin(), times.end(), [](double x) { return std::isnan(x); })) {
      throw std::invalid_argument("empirical_distribution: a problem has no times, or not numbers");
    }
    const auto reached = std::count_if(times.begin(), times.end(),
                                       [&](double x) { return x <= t && !std::isinf(x); });
    shares.push_back(static_cast<double>(reached) / static_cast<double>(times.size()));
  }
  return mean_share(shares, clusters);
}

Costs performance_ratios(const Costs& costs) {
  check_costs(costs);
  Costs ratios = costs;
  for (std::vector<double>& row : ratios) {
    const double least = *std::min_element(row.begin(), row.end());
    for (double& cost : row) {
      cost = std::isinf(cost) ? std::numeric_limits<double>::infinity() : cost / least;
    }
  }
  return ratios;
}

double performance_profile(const Costs& ratios, std::size_t solver, double ratio) {
  if (ratios.empty()) throw std::invalid_argument("performance_profile: no problems");
  double within = 0;
  for (const std::vector<double>& row : ratios) {
    if (solver >= row.size() || row.size() != ratios.front().size() || !(row[solver] >= 0)) {
      throw std::invalid_argument("performance_profile: ratios >= 0 of every solver are needed");
    }
    within += std::isfinite(row[solver]) && row[solver] <= ratio ? 1 : 0;
  }
  return within / static_cast<double>(ratios.size());
}

}  // namespace ricochet
