#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "problems/carrier_track/gradients/profile_motion.h"

namespace ricochet::carrier_track::inline gradients {

/// The derivatives of one quantity along some directions of the variables.
template <int directions>
using TangentRow = Eigen::Matrix<double, 1, directions>;

/// What a sweep forward carries: the derivatives of the time at which the body is somewhere, of its
/// position and its velocity there, and of the plate at a knot.
template <int directions>
struct TangentRows {
  TangentRow<directions> time = TangentRow<directions>::Zero();
  TangentRow<directions> position = TangentRow<directions>::Zero();
  TangentRow<directions> velocity = TangentRow<directions>::Zero();
  PlateRamp<TangentRow<directions>> ramp{TangentRow<directions>::Zero(),
                                         TangentRow<directions>::Zero(),
                                         TangentRow<directions>::Zero()};

  /// From before the end of leg i, where the duration of the leg is given, to after it; see
  /// BodyAdjoint.
  template <class Use>
  void pass_end(const ProfileMotion& motion, std::size_t i, const LinearLeg<double>& leg,
                Use& use) {
    using Change = TangentRow<directions>;
    const Change start = time;
    if (motion.leg(i).end == LegEnd::cut) {
      position -= leg.velocity * start;
      velocity -= leg.acceleration * start;
      time.setZero();
      use.ended(i, start, -start, velocity);
    } else if (motion.leg(i).end == LegEnd::impact) {
      const Change later = (leg.velocity != 0 ? -1 / leg.velocity : 0.0) * position;
      const Change speed = motion.leg(i).direction * (velocity + leg.acceleration * later);
      time += later;
      position.setZero();
      velocity = -motion.restitution(i) * motion.leg(i).direction * speed;
      use.ended(i, start, later, speed);
    } else {
      const Change later = (leg.acceleration != 0 ? -1 / leg.acceleration : 0.0) * velocity;
      time += later;
      velocity.setZero();
      use.ended(i, start, later, position);
    }
    if (!motion.flies_on(i)) velocity.setZero();
  }
};

/// Carries derivatives forward through a motion. `rows` are TangentRows; rows.enter(knot) sets the
/// ramp to that at a knot, none of which comes before the last one. Calls
///   use.ended(i, start, later, state)
/// at the end of leg i, a flight, with the derivatives of its start, its duration and its state:
/// the approach speed of an impact, the position of a turning point, the velocity at a cut.
template <class Rows, class Use>
void sweep_forward(const ProfileMotion& motion, const std::vector<LinearLeg<double>>& legs,
                   Rows& rows, Use& use) {
  for (std::size_t i = 0; i < motion.size(); ++i) {
    if (motion.leg(i).rests) continue;
    const LinearLeg<double>& leg = legs[i];
    const std::size_t knot = motion.knot_before(i);
    rows.enter(knot);
    auto ramp = rows.ramp.after(leg.start - motion.time(knot));
    if (motion.released(i)) {
      rows.time = leg.release.angle * ramp.angle + leg.release.speed * ramp.speed +
                  leg.release.slope * ramp.slope;
    }
    ramp.angle += leg.ramp.speed * rows.time;
    ramp.speed += leg.ramp.slope * rows.time;
    const auto& [by_angle, by_speed, by_slope, by_start] = leg.response;
    rows.position += leg.duration * rows.velocity + by_angle.position * ramp.angle +
                     by_speed.position * ramp.speed + by_slope.position * ramp.slope +
                     by_start.position * rows.time;
    rows.velocity += by_angle.velocity * ramp.angle + by_speed.velocity * ramp.speed +
                     by_slope.velocity * ramp.slope + by_start.velocity * rows.time;
    rows.pass_end(motion, i, leg, use);
  }
}

}  // namespace ricochet::carrier_track::inline gradients
