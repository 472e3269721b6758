#include "solvers/fireworks/spark.h"

#include <algorithm>
#include <cmath>

#include "solvers/fireworks/draws.h"

namespace ricochet::fireworks {
namespace {

/// Sparks at either end of the order.
std::size_t number_of(std::span<const Eigen::Index> order, double share) {
  const auto some = std::max(1L, std::lround(share * static_cast<double>(order.size())));
  return std::min(static_cast<std::size_t>(some), order.size());
}

}  // namespace

void displace(Vector& x, std::span<const Eigen::Index> moved, double amplitude, const Vector& unit,
              Offsets offsets, Random& random) {
  if (offsets == Offsets::one) {
    const double offset = amplitude * two_sided(random);
    for (const Eigen::Index k : moved) x[k] += offset * unit[k];
  } else {
    for (const Eigen::Index k : moved) x[k] += amplitude * two_sided(random) * unit[k];
  }
}

void multiply(Vector& x, std::span<const Eigen::Index> moved, Random& random) {
  const double factor = 1 + normal(1, random)[0];
  for (const Eigen::Index k : moved) x[k] *= factor;
}

void approach(Vector& x, std::span<const Eigen::Index> moved, const Vector& best, Random& random) {
  const double factor = normal(1, random)[0];
  for (const Eigen::Index k : moved) x[k] += (best[k] - x[k]) * factor;
}

void guide(Vector& x, const Eigen::Ref<const Matrix>& sparks, std::span<const Eigen::Index> order,
           double share, double times) {
  const std::size_t count = number_of(order, share);
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Index good = order[k];
    const Eigen::Index bad = order[order.size() - 1 - k];
    x += times * (sparks.row(good) - sparks.row(bad)).transpose() / static_cast<double>(count);
  }
}

Vector mean_of_best(const Eigen::Ref<const Matrix>& sparks, std::span<const Eigen::Index> order,
                    double share) {
  const std::size_t count = number_of(order, share);
  Vector mean = Vector::Zero(sparks.cols());
  for (std::size_t k = 0; k < count; ++k) {
    mean += sparks.row(order[k]).transpose() / static_cast<double>(count);
  }
  return mean;
}

}  // namespace ricochet::fireworks
