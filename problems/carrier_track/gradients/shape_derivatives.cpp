#include "problems/carrier_track/gradients/shape_derivatives.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/carrier_track/gradients/derivatives.h"
#include "problems/carrier_track/gradients/sweeps.h"
#include "problems/carrier_track/scene/scene_values.h"

namespace ricochet::carrier_track::inline gradients {

namespace {

/// Collects the limits on derivatives as TrustWatch does.
class SweepGauge {
 public:
  SweepGauge(const ProfileMotion& motion, const Scene& scene)
      : motion_(motion), scene_(scene), window_(duration_of(scene)) {}

  void ended(std::size_t i, const TangentRow<8>& start, const TangentRow<8>& later,
             const TangentRow<8>& state) {
    const MotionLeg& leg = motion_.leg(i);
    if (leg.end == LegEnd::impact) {
      if (leg.speed > 0) limits_.margin(leg.speed, 2 * state.norm());  // that of its square
      limits_.impact((start + later).norm(), window_);
    } else if (leg.end == LegEnd::turn) {
      const double missed =
          leg.direction > 0 ? scene_.wall_upper - leg.position : leg.position - scene_.wall_lower;
      if (missed > 0 && std::isfinite(missed)) limits_.margin(missed, state.norm());
    }
  }

  const TrustLimits& limits() const { return limits_; }

 private:
  const ProfileMotion& motion_;
  const Scene& scene_;
  double window_;
  TrustLimits limits_;
};

Vector vector_of(const std::vector<double>& entries) {
  return Eigen::Map<const Vector>(entries.data(), static_cast<Eigen::Index>(entries.size()));
}

}  // namespace

Gradient detail::shape_gradient(const Scene& scene, SummedMotion summed,
                                const std::vector<EventTerm>& terms, const ShapedKnots& knots,
                                const Vector& widths) {
  const ProfileMotion motion(scene, std::move(summed.legs));
  const auto legs = linear_legs(motion, terms);
  Gradient result{summed.value, knots.gradient(vector_of(swept_back(motion, legs))), {}};
  GaugeRows rows(motion, knots, widths);
  SweepGauge gauge(motion, scene);
  sweep_forward(motion, legs, rows, gauge);
  const auto& [steepest, growth] = gauge.limits();
  result.trust =
      trust_of(steepest * steepest, growth * growth, result.gradient.cwiseProduct(widths).norm());
  return result;
}

Matrix detail::shape_curvature(const Scene& scene, SummedMotion summed,
                               const std::vector<EventTerm>& terms, const ShapedKnots& knots,
                               const Matrix& directions) {
  const ProfileMotion motion(scene, std::move(summed.legs));
  const auto legs = linear_legs(motion, terms);
  const Matrix changes = SecondSweep(motion, legs, terms).along(knots.along(directions));
  return knots.change(vector_of(swept_back(motion, legs)), changes, directions);
}

Slope surrogate_slope(const Scene& scene, double smoothing, double range) {
  using Jet = ceres::Jet<double, 1>;
  BasicScene<Jet> dual = lifted<Jet>(scene);
  dual.omega.v[0] = 1.0;
  const Vector smoothings = Vector::Constant(1, range);
  TrustGauge<Jet> gauge(smoothings, 0);
  auto watcher = gauge.of(dual);
  const Jet result = objective(dual, smoothing, watcher);
  const double slope = result.v[0];
  return {result.a, slope,
          trust_of(std::pow(gauge.steepest(), 2), std::pow(gauge.growth(), 2),
                   std::abs(slope) * range)};
}

}  // namespace ricochet::carrier_track::inline gradients
