#include "src/benchmark/statistics/exponential.h"

#include <cmath>

namespace ricochet {

Exponential::Exponential() {
  // 256 layers of the same area; the last one is the tail with the block below it. With this edge
  // and area the layers end exactly at height 1.
  constexpr double edge = 7.697117470131050;
  constexpr double area = 0.003949659822581557;
  ends_[0] = area * std::exp(edge);
  ends_[1] = edge;
  for (std::size_t i = 2; i < 256; ++i) {
    ends_[i] = -std::log(area / ends_[i - 1] + std::exp(-ends_[i - 1]));
  }
  ends_[256] = 0;
  for (std::size_t i = 0; i < ends_.size(); ++i) heights_[i] = std::exp(-ends_[i]);
}

double Exponential::beyond(std::size_t layer, double x, Random& random) const {
  if (layer == 0) return ends_[1] + (*this)(random);  // the distribution is memoryless
  const double height = heights_[layer] + uniform(random) * (heights_[layer + 1] - heights_[layer]);
  return height < std::exp(-x) ? x : (*this)(random);
}

}  // namespace ricochet
