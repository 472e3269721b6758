#pragma once

#include <ceres/jet.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "ricochet/machine.h"
#include "ricochet/problem.h"

/// How far exact derivatives of a motion can be trusted. They are valid while the motion keeps its
/// structure: the same impacts, the same turning points. Dual numbers give the rate of change of
/// the margin of each event, and so, to first order, also the point where the event vanishes.
namespace ricochet::carrier_track::inline gradients {

/// A gradient whose reach is shorter than this share of the box is in doubt: no solver's step is so
/// short.
inline constexpr double short_reach = 1e-4;

/// A gradient that changes the value by less than this across the whole box is flat.
inline constexpr double flat_change = 1e-3;

/// A motion is sensitive if an impact's time changes by more than this many windows across the box.
inline constexpr double sensitive_growth = 1e3;

/// The tightest limits on the derivatives of a motion, from lengths of gradients in the unit box.
struct TrustLimits {
  double steepest =
      0;              ///< 1 / reach, to first order: the largest |gradient of g| / g of a margin g
  double growth = 0;  ///< the largest |gradient| of an impact's time divided by the window

  /// Adds a margin > 0 with its |gradient|: the event vanishes where the margin becomes 0.
  void margin(double margin, double slope) {
    if (slope > steepest * margin) steepest = slope / margin;
  }

  /// Adds an impact with the |gradient| of its time.
  void impact(double slope, double window) { growth = std::max(growth, slope / window); }
};

/// Collects the limits on the derivatives of one or several simulations with respect to some
/// variables, in a box of the given widths.
template <class Jet>
class TrustGauge {
 public:
  /// The jets' directions are the variables from `first` on; `widths` must outlive the gauge.
  TrustGauge(const Vector& widths, Eigen::Index first) : widths_(widths), first_(first) {}

  /// An observer of a simulation of this scene, which must outlive it.
  auto of(const BasicScene<Jet>& scene);

  double steepest() const { return limits_.steepest; }
  double growth() const { return limits_.growth; }

  void limit(const Jet& margin) { limits_.margin(margin.a, norm(margin)); }
  void impact(const Jet& time, double window) { limits_.impact(norm(time), window); }

 private:
  double norm(const Jet& x) const {
    double sum = 0;
    const Eigen::Index size = std::min<Eigen::Index>(Jet::DIMENSION, widths_.size() - first_);
    for (Eigen::Index i = 0; i < size; ++i) sum += std::pow(x.v[i] * widths_[first_ + i], 2);
    return std::sqrt(sum);
  }

  const Vector& widths_;
  Eigen::Index first_;
  TrustLimits limits_;
};

/// Reports the margins of a motion between hard walls to a gauge. An impact vanishes where its
/// speed becomes 0; its margin is the square of the speed. A missed wall is touched where the
/// distance to it, its margin, becomes 0.
template <class Jet>
class TrustWatch : public Observer {
 public:
  TrustWatch(TrustGauge<Jet>& gauge, const BasicScene<Jet>& scene)
      : gauge_(gauge), scene_(scene), window_(value(duration_of(scene))) {}

  void impact(const Jet& time, Wall /*wall*/, const Jet& speed) {
    if (speed.a > 0) gauge_.limit(speed * speed);
    gauge_.impact(time, window_);
  }

  void turn(const Jet& /*time*/, const Jet& position, Wall ahead) {
    const Jet missed =
        ahead == Wall::upper ? scene_.wall_upper - position : position - scene_.wall_lower;
    if (missed.a > 0 && std::isfinite(missed.a)) gauge_.limit(missed);
  }

 private:
  TrustGauge<Jet>& gauge_;
  const BasicScene<Jet>& scene_;
  double window_;
};

template <class Jet>
auto TrustGauge<Jet>::of(const BasicScene<Jet>& scene) {
  return TrustWatch<Jet>(*this, scene);
}

/// The trust from the gauges of all blocks of directions. `steepest_square` and `growth_square` are
/// sums over the blocks; the resulting reach is a lower bound. `change` is the gradient's norm in
/// the unit box.
inline Trust trust_of(double steepest_square, double growth_square, double change) {
  Trust trust;
  if (steepest_square > 0) trust.reach = 1 / std::sqrt(steepest_square);
  if (!(change >= flat_change)) {
    trust.doubt = GradientDoubt::flat;
  } else if (trust.reach < short_reach) {
    trust.doubt = growth_square > sensitive_growth * sensitive_growth ? GradientDoubt::sensitive
                                                                      : GradientDoubt::kink;
  }
  return trust;
}

// Exact derivatives, by dual numbers, of a value that is computed from simulations and depends on
// some variables. A Function is called with the variables and with a watcher of every simulation,
// and works for every scalar type:
//
//   template <class Scalar, class Watch>
//   Scalar operator()(std::span<const Scalar> x, Watch& watch) const;
//
// It passes `watch.of(scene)` as an observer to every simulation that the value depends on. A
// Function of a problem defines `static constexpr int jet_size`, the number of directions to
// differentiate at a time: the number of variables. For the shape of a speed profile, which may
// have any number of variables, see shape_derivatives.h.

/// Watches nothing.
struct Unwatched {
  template <class Scalar>
  Observer of(const BasicScene<Scalar>& /*scene*/) {
    return {};
  }
};

/// The value at x.
template <class Function>
double value_of(const Function& f, const Vector& x) {
  Unwatched nobody;
  return f(std::span<const double>(x.data(), static_cast<std::size_t>(x.size())), nobody);
}

struct Gradient {
  double value;
  Vector gradient;  ///< length n
  Trust trust;
};

struct Hessian {
  double value;
  Vector gradient;  ///< length n
  Matrix hessian;   ///< n x n, symmetric
};

namespace detail {

/// The variables as duals; each variable from `first` on has a direction.
template <class Jet>
std::vector<Jet> seeded(const Vector& x, Eigen::Index first) {
  std::vector<Jet> duals;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Jet dual(x[i]);
    if (i >= first && i < first + Jet::DIMENSION) dual.v[i - first] = 1.0;
    duals.push_back(dual);
  }
  return duals;
}

}  // namespace detail

/// Value and gradient at x, and their trust in a box of these `widths` (length n). Differentiates
/// `Room` directions at a time.
template <int Room = 5, class Function>
Gradient gradient_of(const Function& f, const Vector& x, const Vector& widths) {
  using Jet = ceres::Jet<double, Room>;
  Gradient result{0, Vector(x.size()), {}};
  double steepest = 0;
  double growth = 0;
  for (Eigen::Index first = 0; first < x.size(); first += Room) {
    const std::vector<Jet> duals = detail::seeded<Jet>(x, first);
    TrustGauge<Jet> gauge(widths, first);
    const Jet y = f(std::span<const Jet>(duals), gauge);
    result.value = y.a;
    const Eigen::Index size = std::min<Eigen::Index>(Room, x.size() - first);
    for (Eigen::Index i = 0; i < size; ++i) result.gradient[first + i] = y.v[i];
    steepest += gauge.steepest() * gauge.steepest();
    growth += gauge.growth() * gauge.growth();
  }
  result.trust = trust_of(steepest, growth, result.gradient.cwiseProduct(widths).norm());
  return result;
}

namespace detail {

/// The block of second derivatives from row `row` and column `column` on, with value and gradient.
template <int Room, class Function>
void hessian_block(const Function& f, const Vector& x, Eigen::Index row, Eigen::Index column,
                   Hessian& result) {
  using Jet = ceres::Jet<double, Room>;
  using Second = ceres::Jet<Jet, Room>;
  std::vector<Second> duals;
  const std::vector<Jet> columns = seeded<Jet>(x, column);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Second dual(columns[static_cast<std::size_t>(i)]);
    if (i >= row && i < row + Room) dual.v[i - row] = Jet(1.0);
    duals.push_back(dual);
  }
  Unwatched nobody;
  const Second y = f(std::span<const Second>(duals), nobody);
  result.value = y.a.a;
  for (Eigen::Index i = row; i < std::min(row + Room, x.size()); ++i) {
    result.gradient[i] = y.v[i - row].a;
    for (Eigen::Index j = std::max(i, column); j < std::min(column + Room, x.size()); ++j) {
      result.hessian(i, j) = result.hessian(j, i) = y.v[i - row].v[j - column];
    }
  }
}

}  // namespace detail

/// Value, gradient and second derivatives at x, in blocks of `Room` by `Room` directions. Measured:
/// Room = 1 is the fastest for one variable, 2 for up to six.
template <int Room = 2, class Function>
Hessian hessian_of(const Function& f, const Vector& x) {
  Hessian result{0, Vector(x.size()), Matrix(x.size(), x.size())};
  for (Eigen::Index row = 0; row < x.size(); row += Room) {
    for (Eigen::Index column = row; column < x.size(); column += Room) {
      detail::hessian_block<Room>(f, x, row, column, result);
    }
  }
  return result;
}

// The sums over the events of a motion that problems minimise. Each makes the observer that adds
// up a motion of `scene`, which must outlive it, for every scalar type; its total() is the sum.

/// objective_s of count.h.
struct SurrogateSum {
  double smoothing;

  template <class Scalar>
  WeightSum<Scalar> over(const BasicScene<Scalar>& scene) const {
    return {scene, smoothing};
  }
};

/// The wear [mJ] of count.h.
struct WearSum {
  template <class Scalar>
  EnergyLost<Scalar> over(const BasicScene<Scalar>& scene) const {
    return EnergyLost<Scalar>(scene);
  }
};

}  // namespace ricochet::carrier_track::inline gradients
