#pragma once

#include <ceres/jet.h>

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "problems/carrier_track/motion/flight.h"
#include "problems/carrier_track/motion/forces.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/motion/observer.h"
#include "problems/carrier_track/motion/profile_forces.h"
#include "problems/carrier_track/motion/ramp_flight.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/machine.h"
#include "ricochet/problem.h"

namespace ricochet::carrier_track::inline gradients {

/// What ends a leg.
enum class LegEnd {
  cut,     ///< no event of a flight: a knot of the profile, the reach of a series, a release
  impact,  ///< on the wall ahead
  turn     ///< the velocity reaches zero
};

/// A part of a motion, a flight or a rest, in which the forces are one power series.
struct MotionLeg {
  double start;     ///< [s]
  double duration;  ///< [s]
  double velocity;  ///< [m/s] at its start
  bool rests;       ///< the body is at rest
  LegEnd end = LegEnd::cut;
  int direction = 0;    ///< of the flight that contains the leg, or follows it: +1 up, -1 down
  double speed = 0;     ///< [m/s], approach speed of an impact
  double position = 0;  ///< [m], where the event is
  bool peak = false;    ///< the event is a local maximum
};

/// Records the legs of a motion under a speed profile up to its last impact or turning point.
class LegRecord : public Observer {
 public:
  LegRecord() { legs_.reserve(256); }

  template <class Path>
  void stretch(double time, const Path& path, double duration) {
    legs_.push_back({time, duration, path.velocity, std::is_same_v<Path, Flight<double>>});
  }

  void impact(double /*time*/, Wall wall, double speed) { end(LegEnd::impact, wall).speed = speed; }

  void turn(double /*time*/, double position, Wall ahead) {
    end(LegEnd::turn, ahead).position = position;
  }

  /// A maximum is reported when the body leaves it, before any other event.
  void peak(double /*time*/, double position) {
    MotionLeg& summit = legs_[ended_ - 1];
    summit.position = position;
    summit.peak = true;
  }

  std::vector<MotionLeg> legs() && {
    legs_.resize(ended_);
    return std::move(legs_);
  }

 private:
  /// Ends the last leg at an event.
  MotionLeg& end(LegEnd by, Wall ahead) {
    const int direction = ahead == Wall::upper ? +1 : -1;
    for (; ended_ < legs_.size(); ++ended_) legs_[ended_].direction = direction;
    legs_.back().end = by;
    return legs_.back();
  }

  std::vector<MotionLeg> legs_;
  std::size_t ended_ = 0;  // legs up to the last event
};

/// The derivatives of the motion at the end of a flight of a given duration with respect to what
/// the forces depend on: the angle, the speed and the slope of the driver plate at its start, and,
/// for the disturbance, the time of the start. The forces do not depend on position or velocity, so
/// these add to what free motion makes of those.
template <class Scalar>
struct LegResponse {
  Motion<Scalar> by_angle, by_speed, by_slope, by_start;
};

/// The response of a flight of this duration [s] that starts at `start` [s].
template <class Scalar>
LegResponse<Scalar> response_of(const PlateForces<double>& plate,
                                const Harmonic<double>& disturbance, const Scalar& start,
                                const PlateRamp<Scalar>& ramp, double duration) {
  const RotationTaylor<Scalar> turning(ramp.angle, ramp.speed, ramp.slope);
  const RampPartials<Scalar> partials(plate, ramp.speed, ramp.slope, turning);
  const auto integrated = [duration](const Series<Scalar>& series) {
    const Motion<Scalar> by = integrals(series, duration);
    return Motion<Scalar>{by.position * (duration * duration), by.velocity * duration,
                          by.acceleration};
  };
  LegResponse<Scalar> response{integrated(partials.by_alpha),
                               integrated(partials.by_omega),
                               integrated(partials.by_slope),
                               {}};
  if (disturbance.cosine != 0 || disturbance.sine != 0) {
    const auto [cosine, sine, frequency] = after(disturbance, start);
    const Swung<Scalar> by =
        swung<Scalar>({-frequency * sine, frequency * cosine, frequency}, Scalar(duration));
    response.by_start = {by.position, by.velocity, by.cosine};
  }
  return response;
}

/// A flight linearised, with the event that ends it: all that a sweep needs. Scalar is double, or a
/// dual along directions of the knots' speeds.
template <class Scalar>
struct LinearLeg {
  Scalar start;               ///< [s]
  Scalar duration;            ///< [s]
  Scalar velocity;            ///< [m/s] at its end
  Scalar by_time;             ///< derivatives of the event's term, see EventTerm
  Scalar by_state;            ///< the same
  PlateRamp<double> release;  ///< of the start with respect to the ramp there, after a rest
  PlateRamp<Scalar> ramp{};   ///< at its start
  Scalar acceleration{};      ///< [m/s^2] at its end, if its start or its end may move
  LegResponse<Scalar> response{};
};

// What an adjoint sweep needs of a sum over the events of a motion, an EventSum of derivatives.h.

/// The derivatives of the term of one event with respect to its time [s] and to its state: the
/// approach speed of an impact [m/s], or the position of a turning point [m].
struct EventTerm {
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  Eigen::Matrix2d curvature = Eigen::Matrix2d::Zero();
};

/// A sum over a motion, and the motion.
struct SummedMotion {
  double value;
  std::vector<MotionLeg> legs;
};

/// Simulates a valid scene of fidelity impact with a speed profile.
template <class EventSum>
SummedMotion summed_motion(const EventSum& of, const Scene& scene) {
  auto sum = of.over(scene);
  LegRecord record;
  ObserverPair both(sum, record);
  ImpactModel<double, ProfileForces<double>>(scene).run(both);
  return {sum.total(), std::move(record).legs()};
}

namespace detail {

/// What the event at the end of a leg adds to an empty sum.
template <class Scalar, class Sum>
Scalar term_of(Sum sum, const MotionLeg& leg, const Scalar& time, const Scalar& state) {
  if (leg.end == LegEnd::impact) {
    sum.impact(time, leg.direction > 0 ? Wall::upper : Wall::lower, state);
    if (leg.peak) sum.peak(time, constant<Scalar>(leg.position));
  } else if (leg.peak) {
    sum.peak(time, state);
  }
  return sum.total();
}

/// Copies the derivatives of a term.
inline void keep(const ceres::Jet<double, 2>& term, EventTerm& result) {
  result.slope = term.v;
}

inline void keep(const ceres::Jet<ceres::Jet<double, 2>, 2>& term, EventTerm& result) {
  for (int i = 0; i < 2; ++i) {
    result.slope[i] = term.v[i].a;
    result.curvature.row(i) = term.v[i].v;
  }
}

/// A dual with derivatives up to an order along a direction, 0 or 1.
template <int order>
auto input(double value, int direction) {
  using Dual = ceres::Jet<double, 2>;
  if constexpr (order == 1) {
    return Dual(value, direction);
  } else {
    return ceres::Jet<Dual, 2>(Dual(value, direction), direction);
  }
}

}  // namespace detail

/// The derivatives of the terms up to an order, 1 or 2, one for each leg of a motion of `scene`.
template <int order, class EventSum>
std::vector<EventTerm> event_terms(const EventSum& of, Scene scene,
                                   const std::vector<MotionLeg>& legs) {
  using Dual = decltype(detail::input<order>(0, 0));
  scene.profile.clear();
  const BasicScene<Dual> constants = lifted<Dual>(scene);
  const auto nothing = of.over(constants);
  std::vector<EventTerm> terms(legs.size());
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const MotionLeg& leg = legs[i];
    if (leg.end == LegEnd::cut) continue;
    const double state = leg.end == LegEnd::impact ? leg.speed : leg.position;
    const Dual term =
        detail::term_of(nothing, leg, detail::input<order>(leg.start + leg.duration, 0),
                        detail::input<order>(state, 1));
    detail::keep(term, terms[i]);
  }
  return terms;
}

/// A motion under a speed profile as legs, each of which lies between two knots.
class ProfileMotion {
 public:
  /// `scene` must be valid, of fidelity impact, its window in seconds, with at least two knots, the
  /// first at time 0 and the last at the window's end.
  ProfileMotion(const Scene& scene, std::vector<MotionLeg> legs);

  std::size_t size() const { return legs_.size(); }
  const MotionLeg& leg(std::size_t i) const { return legs_[i]; }
  /// Returns true if a flight follows leg i.
  bool flies_on(std::size_t i) const { return i + 1 < legs_.size() && !legs_[i + 1].rests; }
  /// Returns true if leg i begins a flight after a rest.
  bool released(std::size_t i) const { return i > 0 && legs_[i - 1].rests && !legs_[i].rests; }
  /// Returns true if leg i starts at a time that depends on the motion before, not at a cut.
  bool start_moves(std::size_t i) const {
    return i > 0 && (legs_[i - 1].rests || legs_[i - 1].end != LegEnd::cut);
  }

  std::size_t knots() const { return times_.size(); }
  double time(std::size_t knot) const { return times_[knot]; }  ///< [s]
  /// The time from a knot to the next [s].
  double span(std::size_t knot) const { return times_[knot + 1] - times_[knot]; }
  /// The knot before leg i.
  std::size_t knot_before(std::size_t i) const { return before_[i]; }

  double restitution(std::size_t i) const { return restitution_[legs_[i].direction > 0]; }

  /// The plate at every knot but the last, if the knots have these speeds [rad/s].
  template <class Scalar>
  std::vector<PlateRamp<Scalar>> ramps(std::span<const Scalar> speeds) const {
    std::vector<PlateRamp<Scalar>> ramps;
    PlateRamp<Scalar> ramp{Scalar(phase_)};
    for (std::size_t k = 0; k + 1 < knots(); ++k) {
      ramp.speed = speeds[k];
      ramp.slope = (speeds[k + 1] - speeds[k]) * (1 / span(k));
      ramps.push_back(ramp);
      ramp = ramp.after(span(k));
    }
    return ramps;
  }
  const std::vector<PlateRamp<double>>& ramps() const { return ramps_; }
  /// The plate at the start of leg i.
  PlateRamp<double> ramp(std::size_t i) const {
    return ramps_[before_[i]].after(legs_[i].start - times_[before_[i]]);
  }
  double speed(std::size_t knot) const { return speeds_[knot]; }  ///< [rad/s]

  /// The acceleration [m/s^2] of leg i, a flight, at a time [s].
  template <class Scalar>
  Scalar acceleration(std::size_t i, const Scalar& time, const PlateRamp<Scalar>& ramp) const {
    Scalar sum = acceleration_of(plate_, ramp) - legs_[i].direction * friction_;
    if (disturbance_.cosine != 0 || disturbance_.sine != 0) sum += after(disturbance_, time).cosine;
    return sum;
  }

  /// The response of leg i, a flight that starts at `ramp`.
  template <class Scalar>
  LegResponse<Scalar> response(std::size_t i, const Scalar& start,
                               const PlateRamp<Scalar>& ramp) const {
    return response_of(plate_, disturbance_, start, ramp, legs_[i].duration);
  }

  /// The derivatives of the start of leg i, the release of a body at rest, with respect to the ramp
  /// there. A force that jumps out of the band of friction, at a knot, does so at a fixed time.
  PlateRamp<double> release(std::size_t i) const;

 private:
  PlateForces<double> plate_;
  Harmonic<double> disturbance_;
  double friction_;  // [m/s^2]
  double restitution_[2];
  double phase_;
  std::vector<double> times_, speeds_;  // of the knots
  std::vector<PlateRamp<double>> ramps_;
  std::vector<MotionLeg> legs_;
  std::vector<std::size_t> before_;
};

/// Completes legs of which all is known but ramp, acceleration and response. `ramps` has the plate
/// at the knots; `respond(i)` returns the response of leg i, with its ramp. Rests stay empty.
template <class Scalar, class Respond>
void complete(const ProfileMotion& motion, const std::vector<PlateRamp<Scalar>>& ramps,
              std::vector<LinearLeg<Scalar>>& legs, const Respond& respond) {
  for (std::size_t i = 0; i < motion.size(); ++i) {
    if (motion.leg(i).rests) continue;
    LinearLeg<Scalar>& leg = legs[i];
    const std::size_t knot = motion.knot_before(i);
    leg.ramp = ramps[knot].after(leg.start - motion.time(knot));
    leg.response = respond(i);
    if (motion.leg(i).end == LegEnd::cut && !motion.start_moves(i)) continue;
    leg.acceleration =
        motion.acceleration(i, Scalar(leg.start + leg.duration), leg.ramp.after(leg.duration));
  }
}

/// The flights of a motion, linearised, with these terms, one for each leg.
std::vector<LinearLeg<double>> linear_legs(const ProfileMotion& motion,
                                           const std::vector<EventTerm>& terms);

/// The speeds of knots that are a shape x scaled to a given mean:
///   speed k = scale x_k, with a scale inversely proportional to weights . x,
/// so that its derivatives are d speed k / d x_i = scale [i = k] - speed k share i.
struct ShapedKnots {
  double scale;   ///< [rad/s]
  Vector speeds;  ///< [rad/s], length n
  Vector share;   ///< weights / (weights . x), length n

  /// The gradient with respect to the shape, from that with respect to the speeds.
  Vector gradient(const Vector& by_speeds) const {
    return scale * by_speeds - speeds.dot(by_speeds) * share;
  }

  /// How the speeds change along directions of the shape, the columns of a matrix.
  Matrix along(const Matrix& directions) const {
    return scale * directions - speeds * (share.transpose() * directions);
  }

  /// How the gradient changes along these directions; `changes` has how that with respect to the
  /// speeds changes.
  Matrix change(const Vector& by_speeds, const Matrix& changes, const Matrix& directions) const {
    const Eigen::RowVectorXd shrinks = share.transpose() * directions;
    const Eigen::RowVectorXd turns =
        speeds.transpose() * changes + by_speeds.transpose() * along(directions);
    return scale * (changes - by_speeds * shrinks) -
           share * (turns - speeds.dot(by_speeds) * shrinks);
  }
};

}  // namespace ricochet::carrier_track::inline gradients
