#include "src/benchmark/statistics/ranks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>

namespace ricochet {

std::vector<double> ranks_of(const std::vector<double>& sample) {
  if (std::any_of(sample.begin(), sample.end(), [](double x) { return std::isnan(x); })) {
    throw std::invalid_argument("ranks_of: a value is not a number");
  }
  std::vector<std::size_t> order(sample.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t k) { return sample[i] < sample[k]; });
  std::vector<double> ranks(sample.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first;
    while (last < order.size() && sample[order[last]] == sample[order[first]]) ++last;
    const double shared = static_cast<double>(first + last + 1) / 2;
    for (; first < last; ++first) ranks[order[first]] = shared;
  }
  return ranks;
}

}  // namespace ricochet
