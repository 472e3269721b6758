#include "src/benchmark/analysis/stratified_sample.h"

#include <algorithm>
#include <numeric>

#include "ricochet/random.h"

namespace ricochet::comparison {

std::vector<std::size_t> stratified_sample(const std::vector<double>& values, std::size_t number,
                                           std::uint64_t seed) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
  if (number >= order.size()) return order;
  Random random(seed);
  std::vector<std::size_t> drawn;
  for (std::size_t stratum = 0; stratum < number; ++stratum) {
    const std::size_t from = stratum * order.size() / number;
    const std::size_t to = (stratum + 1) * order.size() / number;
    const double place = uniform(random) * static_cast<double>(to - from);
    drawn.push_back(order[from + static_cast<std::size_t>(place)]);
  }
  return drawn;
}

}  // namespace ricochet::comparison
