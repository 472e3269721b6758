#pragma once

#include <cstddef>
#include <vector>

#include "problems/carrier_track/gradients/profile_motion.h"

namespace ricochet::carrier_track::inline gradients {

namespace detail {

/// The adjoint of a body: the derivatives of the sum over all later events with respect to the time
/// at which it is somewhere, its position and its velocity there.
template <class Scalar>
struct BodyAdjoint {
  Scalar time{};
  Scalar position{};
  Scalar velocity{};

  /// From after the end of leg i, a flight, to before it, where the duration of the leg is given:
  /// by the implicit function theorem an impact is later by -position / velocity, a turning point
  /// by -velocity / acceleration, and the end at a cut by -time.
  void pass_end(const ProfileMotion& motion, std::size_t i, const LinearLeg<Scalar>& leg) {
    const Scalar zero(0.0);
    if (motion.leg(i).end == LegEnd::cut) {
      time = motion.start_moves(i)
                 ? Scalar(-(position * leg.velocity + velocity * leg.acceleration))
                 : zero;
      return;
    }
    if (!motion.flies_on(i)) time = velocity = zero;
    time += leg.by_time;
    if (motion.leg(i).end == LegEnd::impact) {
      velocity = static_cast<double>(motion.leg(i).direction) * leg.by_state -
                 motion.restitution(i) * velocity;
      // Touching a wall with zero velocity has no derivative; its time is taken as constant.
      position = value(leg.velocity) != 0
                     ? Scalar(-(time + velocity * leg.acceleration) / leg.velocity)
                     : zero;
    } else {
      position += leg.by_state;
      velocity = value(leg.acceleration) != 0 ? Scalar(-time / leg.acceleration) : zero;
    }
  }
};

}  // namespace detail

/// The derivatives of a sum over the events of a motion with respect to the speeds of the knots
/// [1/(rad/s)]: one sweep from the last event back to the start.
template <class Scalar>
std::vector<Scalar> swept_back(const ProfileMotion& motion,
                               const std::vector<LinearLeg<Scalar>>& legs) {
  std::vector<PlateRamp<Scalar>> ramps(motion.knots() - 1);  // adjoints
  detail::BodyAdjoint<Scalar> body;
  for (std::size_t i = motion.size(); i-- > 0;) {
    if (motion.leg(i).rests) continue;
    const LinearLeg<Scalar>& leg = legs[i];
    body.pass_end(motion, i, leg);
    const auto along = [&](const Motion<Scalar>& by) -> Scalar {
      return body.position * by.position + body.velocity * by.velocity;
    };
    const std::size_t knot = motion.knot_before(i);
    const Scalar since = leg.start - motion.time(knot);
    Scalar angle = along(leg.response.by_angle);
    Scalar speed = along(leg.response.by_speed);
    Scalar slope = along(leg.response.by_slope);
    if (motion.start_moves(i)) {
      body.time += angle * leg.ramp.speed + speed * leg.ramp.slope + along(leg.response.by_start);
    }
    if (motion.released(i)) {
      angle += body.time * leg.release.angle;
      speed += body.time * leg.release.speed;
      slope += body.time * leg.release.slope;
    }
    ramps[knot].angle += angle;
    ramps[knot].speed += angle * since + speed;
    ramps[knot].slope += (0.5 * angle * since + speed) * since + slope;
    body.velocity += body.position * leg.duration;
  }
  std::vector<Scalar> speeds(motion.knots(), Scalar(0.0));
  Scalar angle(0.0);  // adjoint of the angle at the knot after
  for (std::size_t k = ramps.size(); k-- > 0;) {
    const Scalar slope = ramps[k].slope * (1 / motion.span(k));
    const Scalar half = angle * (0.5 * motion.span(k));
    speeds[k + 1] += half + slope;
    speeds[k] += ramps[k].speed + half - slope;
    angle += ramps[k].angle;
  }
  return speeds;
}

}  // namespace ricochet::carrier_track::inline gradients
