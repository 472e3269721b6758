#pragma once

#include <utility>
#include <vector>

#include "problems/carrier_track/gradients/derivatives.h"
#include "problems/carrier_track/gradients/event_terms.h"
#include "problems/carrier_track/gradients/profile_motion.h"
#include "problems/carrier_track/gradients/shaped_knots.h"

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

}  // namespace ricochet::carrier_track::inline gradients
