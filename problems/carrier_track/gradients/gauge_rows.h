#pragma once

#include <Eigen/Core>
#include <vector>

#include "problems/carrier_track/gradients/profile_motion.h"
#include "problems/carrier_track/gradients/shaped_knots.h"
#include "problems/carrier_track/gradients/tangent_sweep.h"

namespace ricochet::carrier_track::inline gradients {

/// Rows of a sweep forward whose lengths are those of gradients with respect to a shape of any
/// length in the unit box. Before a knot, all that is carried on is seven gradients: of time,
/// position, velocity and angle, of the speeds of two knots, and the share of the shape that scales
/// it. They span a space of at most seven directions, beside that of the share of later knots:
/// their coordinates there are the rows.
class GaugeRows : public TangentRows<8> {
 public:
  /// `knots` and `motion` must outlive the rows. `widths`: of the box, length n.
  GaugeRows(const ProfileMotion& motion, const ShapedKnots& knots, const Vector& widths);

  void enter(std::size_t knot);

 private:
  /// Appends the gradient of a knot's speed, and turns the directions to those that are needed.
  void append(Eigen::Index knot);

  const ProfileMotion& motion_;
  const ShapedKnots& knots_;
  Vector widths_;
  Vector later_;  // length of the share of this knot and all later ones
  std::size_t knot_ = 0;
  TangentRow<8> next_ = TangentRow<8>::Zero();   // of the speed of the knot after
  TangentRow<8> share_ = TangentRow<8>::Zero();  // of the sum by which the shape is scaled
};

}  // namespace ricochet::carrier_track::inline gradients
