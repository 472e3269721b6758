#include "solvers/fireworks/selection.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solvers/fireworks/draws.h"

namespace ricochet::fireworks {
namespace {

/// Draws an index with probabilities proportional to the weights, which are >= 0 and not all 0.
Eigen::Index spin(const Vector& weights, Random& random) {
  double left = share(random) * weights.sum();
  Eigen::Index last = 0;
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    last = i;
    left -= weights[i];
    if (left < 0) break;
  }
  return last;
}

/// For points in any dimension, pair by pair.
Vector sums_in_space(const Eigen::Ref<const Matrix>& points) {
  Vector sums = Vector::Zero(points.rows());
  Eigen::ArrayXd distance(points.rows());
  for (Eigen::Index i = 1; i < points.rows(); ++i) {
    auto to_earlier = distance.head(i);
    to_earlier = (points.col(0).head(i).array() - points(i, 0)).square();
    for (Eigen::Index k = 1; k < points.cols(); ++k) {
      to_earlier += (points.col(k).head(i).array() - points(i, k)).square();
    }
    to_earlier = to_earlier.sqrt();
    sums.head(i).array() += to_earlier;
    sums[i] = to_earlier.sum();
  }
  return sums;
}

/// For points on a line, sorted: from one point to the next, the distances to all points on one
/// side grow by the gap, those to all points on the other side shrink by it. Summing over pairs
/// would take most of the time of a run.
Vector sums_on_a_line(const Eigen::Ref<const Matrix>& points) {
  const auto count = static_cast<std::size_t>(points.rows());
  std::vector<std::pair<double, Eigen::Index>> order(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    order[i] = {points(row, 0), row};
  }
  // Tied points have the same sum, in any order.
  std::sort(order.begin(), order.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  Vector sums = Vector::Zero(points.rows());
  double to_left = 0, to_right = 0;
  for (std::size_t i = 1; i < count; ++i) {
    to_left += static_cast<double>(i) * (order[i].first - order[i - 1].first);
    sums[order[i].second] += to_left;
    const std::size_t j = count - 1 - i;
    to_right += static_cast<double>(i) * (order[j + 1].first - order[j].first);
    sums[order[j].second] += to_right;
  }
  return sums;
}

}  // namespace

Eigen::Index best_of(std::span<const TrueValues> worths, Ties ties, Random& random) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < worths.size(); ++i) {
    if (better(worths[i], worths[best])) best = i;
  }
  if (ties == Ties::any) {
    std::vector<std::size_t> equals = {best};
    for (std::size_t i = best + 1; i < worths.size(); ++i) {
      if (!better(worths[best], worths[i])) equals.push_back(i);
    }
    if (equals.size() > 1) best = equals[one_of(equals.size(), random)];
  }
  return static_cast<Eigen::Index>(best);
}

Vector distance_sums(const Eigen::Ref<const Matrix>& points) {
  const Vector sums = points.cols() == 1 ? sums_on_a_line(points) : sums_in_space(points);
  const double total = sums.sum();
  return total > 0 && std::isfinite(total) ? sums : Vector(Vector::Ones(points.rows()));
}

std::vector<Eigen::Index> selected(const Eigen::Ref<const Matrix>& points,
                                   std::span<const TrueValues> worths, int count,
                                   const SelectionOptions& options, Random& random) {
  std::vector<Eigen::Index> chosen = {best_of(worths, options.ties, random)};
  chosen.reserve(static_cast<std::size_t>(count));
  Vector weights = Vector::Ones(points.rows());
  if (options.others == Others::by_distance) weights = distance_sums(points);
  while (chosen.size() < static_cast<std::size_t>(count)) {
    if (!options.replacement) weights[chosen.back()] = 0;
    chosen.push_back(spin(weights, random));
  }
  return chosen;
}

}  // namespace ricochet::fireworks
