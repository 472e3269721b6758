#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "problems/carrier_track/models/impact_model.h"
#include "ricochet/problem.h"
#include "ricochet/recording.h"

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

}  // namespace ricochet::carrier_track::inline gradients
