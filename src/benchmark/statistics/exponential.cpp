#include "src/statistics/exponential.h"

#include <cmath>

namespace ricochet {

Exponential::Exponential() {
  // Layers of the same area, the last of which is the tail with the block below it: theirs is the
  // pair of edge and area for which 256 layers reach exactly up to 1.
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
  if (layer == 0) return ends_[1] + (*this)(random);  // it has no memory
  const double height = heights_[layer] + uniform(random) * (heights_[layer + 1] - heights_[layer]);
  return height < std::exp(-x) ? x : (*this)(random);
}

}  // namespace ricochet
