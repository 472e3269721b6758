#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "problems/carrier_track/gradients/profile_motion.h"
#include "ricochet/problem.h"

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
