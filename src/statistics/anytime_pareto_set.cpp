#include "src/statistics/anytime_pareto_set.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace ricochet {

std::vector<std::size_t> anytime_pareto_set(const std::vector<std::vector<double>>& values) {
  for (const std::vector<double>& row : values) {
    if (row.empty() || row.size() != values.front().size() ||
        std::any_of(row.begin(), row.end(), [](double x) { return std::isnan(x); })) {
      throw std::invalid_argument("anytime_pareto_set: values at the same checkpoints are needed");
    }
  }
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const bool beaten = std::any_of(values.begin(), values.end(), [&](const auto& rival) {
      return std::equal(rival.begin(), rival.end(), values[k].begin(), std::less<>());
    });
    if (!beaten) kept.push_back(k);
  }
  return kept;
}

}  // namespace ricochet
