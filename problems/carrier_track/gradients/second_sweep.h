#pragma once

#include <vector>

#include "problems/carrier_track/gradients/event_terms.h"
#include "problems/carrier_track/gradients/profile_motion.h"
#include "ricochet/vector.h"

namespace ricochet::carrier_track::inline gradients {

/// Second derivatives of a sum over the events of a motion with respect to the speeds of the knots.
/// The response of every leg is differentiated once, with respect to the few quantities that it
/// depends on. Along a direction, a sweep forward then gives the derivatives of all legs, and a
/// sweep back in dual numbers that of the gradient.
class SecondSweep {
 public:
  /// `motion` and the other arguments, with second derivatives of the terms, must outlive it.
  SecondSweep(const ProfileMotion& motion, const std::vector<LinearLeg<double>>& legs,
              const std::vector<EventTerm>& terms);

  /// How the gradient changes along directions, the columns of a matrix of n rows.
  Matrix along(const Matrix& directions) const;

 private:
  using Local = ceres::Jet<double, 4>;  // along angle, speed, slope and time at the start of a leg

  template <int size>
  Eigen::Matrix<double, Eigen::Dynamic, size> sweep(
      const Eigen::Matrix<double, Eigen::Dynamic, size>& directions) const;

  const ProfileMotion& motion_;
  const std::vector<LinearLeg<double>>& legs_;
  const std::vector<EventTerm>& terms_;
  std::vector<LegResponse<Local>> responses_;
};

}  // namespace ricochet::carrier_track::inline gradients
