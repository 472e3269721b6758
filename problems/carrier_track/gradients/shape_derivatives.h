#pragma once

#include <span>
#include <utility>
#include <vector>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/gradients/derivatives.h"
#include "problems/carrier_track/gradients/profile_motion.h"
#include "problems/carrier_track/scene/scene_values.h"

/// Exact derivatives of a sum over the events of a motion with respect to the shape of its speed
/// profile, by the adjoint method: one simulation, one sweep back over its legs, whatever the
/// number of knots. Second derivatives along a direction take one sweep forward and one back in
/// dual numbers, leg by leg.
///
/// `scene` has the shaped profile and is as ProfileMotion needs it.
namespace ricochet::carrier_track::inline gradients {

namespace detail {

Gradient shape_gradient(const Scene& scene, SummedMotion motion,
                        const std::vector<EventTerm>& terms, const ShapedKnots& knots,
                        const Vector& widths);

Matrix shape_curvature(const Scene& scene, SummedMotion motion, const std::vector<EventTerm>& terms,
                       const ShapedKnots& knots, const Matrix& directions);

}  // namespace detail

/// Value and gradient, and their trust in a box of these `widths` (length n).
template <class EventSum>
Gradient shape_gradient(const EventSum& of, const Scene& scene, const ShapedKnots& knots,
                        const Vector& widths) {
  SummedMotion motion = summed_motion(of, scene);
  const auto terms = event_terms<1>(of, scene, motion.legs);
  return detail::shape_gradient(scene, std::move(motion), terms, knots, widths);
}

/// The matrix of second derivatives times `directions`, the columns of a matrix of n rows.
template <class EventSum>
Matrix shape_curvature(const EventSum& of, const Scene& scene, const ShapedKnots& knots,
                       const Matrix& directions) {
  SummedMotion motion = summed_motion(of, scene);
  const auto terms = event_terms<2>(of, scene, motion.legs);
  return detail::shape_curvature(scene, std::move(motion), terms, knots, directions);
}

/// The objective of count.h at a constant speed, x[0] [rad/s]; a Function of derivatives.h.
struct ObjectiveAtSpeed {
  static constexpr int jet_size = 1;

  Scene scene;
  double smoothing;

  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& watch) const {
    const BasicScene<Scalar> at = at_speed(lifted<Scalar>(scene), x[0]);
    auto watching = watch.of(at);
    return objective(at, smoothing, watching);
  }
};

struct Slope {
  double value;
  double slope;  ///< per rad/s
  Trust trust;   ///< in a box of the given width
};

/// The surrogate of a valid scene, smoothing parameter > 0, and its exact derivative with respect
/// to omega, which may vary over a range [rad/s].
Slope surrogate_slope(const Scene& scene, double smoothing, double range = 18.0);

}  // namespace ricochet::carrier_track::inline gradients
