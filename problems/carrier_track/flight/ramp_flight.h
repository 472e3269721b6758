#pragma once

#include <cmath>
#include <limits>

#include "problems/carrier_track/flight/flight.h"
#include "problems/carrier_track/flight/ramp_forces.h"
#include "problems/carrier_track/flight/rotation_taylor.h"

namespace ricochet::carrier_track::inline flight {

/// Free motion while the driver plate's speed changes linearly. The forces are then entire
/// functions of time, not harmonics. Their Taylor series is integrated term by term; it is
/// truncated below rounding (relative error at the reach below 1e-18). A flight is valid for
/// `reach` seconds from its start, about a third of a radian, and only while the velocity keeps its
/// sign, because it includes friction. The same concept as Flight.
template <class Scalar>
class RampFlight {
 public:
  Scalar position;  ///< [m] now
  Scalar velocity;  ///< [m/s] now

  /// A flight that starts now.
  RampFlight(const Scalar& start_position, const Scalar& start_velocity,
             const RampForces<Scalar>& forces)
      : RampFlight(start_position, start_velocity, forces,
                   {forces.alpha, forces.omega, forces.slope}) {}

  /// The same, with the plate's series given by the caller, who uses them elsewhere too.
  RampFlight(const Scalar& start_position, const Scalar& start_velocity,
             const RampForces<Scalar>& forces, const RotationTaylor<Scalar>& turning)
      : position(start_position),
        velocity(start_velocity),
        start_position_(start_position),
        start_velocity_(start_velocity),
        bounds_(bounds_of(forces)) {
    expand(forces, turning);
    acceleration_ = series_[0];
    jerk_ = series_[1];
    snap_ = scaled(series_[2], 2);
  }

  /// The plain values of another flight, for the search of events.
  template <class Other>
  explicit RampFlight(const RampFlight<Other>& other)
      : position(value(other.position)),
        velocity(value(other.velocity)),
        start_position_(value(other.start_position_)),
        start_velocity_(value(other.start_velocity_)),
        elapsed_(value(other.elapsed_)),
        acceleration_(value(other.acceleration_)),
        jerk_(value(other.jerk_)),
        snap_(value(other.snap_)),
        bounds_(other.bounds_) {
    for (std::size_t k = 0; k < series_terms; ++k) series_[k] = value(other.series_[k]);
  }

  RampFlight<double> plain() const { return RampFlight<double>(*this); }
  /// See Flight.
  RampFlight<double> inner() const requires(DerivativeOrder<Scalar>::value == 1) { return plain(); }

  /// Exact up to rounding at any t [s] from now, within the reach.
  Motion<Scalar> at(const Scalar& t) const {
    const Scalar time = elapsed_ + t;
    const auto [x, v, a] = integrals(series_, time);
    return {start_position_ + time * (start_velocity_ + time * x), start_velocity_ + time * v, a};
  }

  /// Restarts from another position and velocity under the same forces.
  void start(const Scalar& from, const Scalar& with) {
    position = start_position_ = from;
    velocity = start_velocity_ = with;
  }

  /// Moves the origin of the position by -`by` [m].
  void shift(const Scalar& by) {
    position += by;
    start_position_ += by;
  }

  /// The forces at any t [s] within the reach.
  AppliedForce applied_at(double t) const {
    RampFlight<double> there = plain();
    there.advance(t);
    return {there.acceleration(), there.jerk()};
  }

  /// Adds `factor` times the forces of a flight that begins at the same time.
  void add(double factor, const RampFlight& other) {
    const Scalar by = constant<Scalar>(factor);
    for (std::size_t k = 0; k < series_terms; ++k) series_[k] += by * other.series_[k];
    acceleration_ += by * other.acceleration_;
    jerk_ += by * other.jerk_;
    snap_ += by * other.snap_;
    const double size = std::abs(factor);
    ForceBounds& bounds = bounds_.forces;
    const ForceBounds& more = other.bounds_.forces;
    bounds_.size += size * other.bounds_.size;
    bounds.acceleration += size * more.acceleration;
    bounds.jerk += size * more.jerk;
    bounds.snap += size * more.snap;
    bounds.shortest_step = std::fmin(bounds.shortest_step, more.shortest_step);
    bounds_.reach = std::fmin(bounds_.reach, other.bounds_.reach);
  }

  /// Adds a steady acceleration [m/s^2].
  void push(const Scalar& by) {
    series_[0] += by;
    acceleration_ += by;
    bounds_.size += std::abs(value(by));
    bounds_.forces.acceleration += std::abs(value(by));
  }

  /// Lets `t` [s] pass.
  void advance(const Scalar& t) {
    const Motion<Scalar> m = at(t);
    elapsed_ += t;
    position = m.position;
    velocity = m.velocity;
    acceleration_ = m.acceleration;
    jerk_ = snap_ = constant<Scalar>(0.0);
    for (std::size_t k = series_terms; k-- > 1;) {
      const auto order = static_cast<double>(k);
      jerk_ = jerk_ * elapsed_ + scaled(series_[k], order);
      if (k > 1) snap_ = snap_ * elapsed_ + scaled(series_[k], order * (order - 1));
    }
  }

  /// See Flight. Changes only position and velocity.
  template <class Tangent>
  void shift_time_derivative(const Tangent& t) requires Dual<Scalar> {
    position.v += t * velocity.a;
    velocity.v += t * acceleration_.a;
  }

  const Scalar& acceleration() const { return acceleration_; }  ///< [m/s^2]
  double plain_acceleration() const { return value(acceleration_); }
  auto inner_acceleration() const requires Dual<Scalar> { return acceleration_.a; }
  const Scalar& jerk() const { return jerk_; }  ///< [m/s^3]
  const Scalar& snap() const { return snap_; }  ///< [m/s^4]

  /// See Flight; valid at the start only.
  typename Flight<Scalar>::Taylor taylor() const {
    typename Flight<Scalar>::Taylor taylor{{}, bounds_.reach / 15};
    for (std::size_t k = 0; k < taylor.coefficient.size(); ++k) {
      taylor.coefficient[k] = value(series_[k]);
    }
    return taylor;
  }

  /// How long [s] the flight is valid, from its start.
  double reach() const { return bounds_.reach; }

  /// Sum of the magnitudes that made up the first acceleration [m/s^2].
  double size() const { return bounds_.size; }
  /// Bounds over the reach.
  double jerk_bound() const { return bounds_.forces.jerk; }
  const ForceBounds& bounds(double /*until*/) const { return bounds_.forces; }

  /// See Flight. Returns no useful bound: a reach is too short for one to matter.
  typename Flight<Scalar>::Speeds speeds(int /*direction*/, double /*time*/) const {
    return {-std::numeric_limits<double>::infinity(), 0};
  }

 private:
  template <class>
  friend class RampFlight;

  void expand(const RampForces<Scalar>& forces, const RotationTaylor<Scalar>& turning) {
    const auto& plate = forces.plate;
    const auto& disturbance = forces.disturbance;
    Scalar even = disturbance.cosine;
    Scalar odd = -disturbance.frequency * disturbance.sine;
    const Scalar rate = disturbance.frequency * disturbance.frequency;
    const Scalar cosine = plate.cosine + plate.slope_cosine * forces.slope;
    const Scalar sine = plate.sine + plate.slope_sine * forces.slope;
    for (std::size_t k = 0; k < series_terms; ++k) {
      series_[k] = cosine * turning.cosine[k] + plate.square_cosine * turning.square_cosine[k] +
                   sine * turning.sine[k] + plate.square_sine * turning.square_sine[k] +
                   (k % 2 == 0 ? even : odd);
      if (k < 3) series_[k] += plate.square * turning.square[k];
      if (k % 2 == 1) {
        const auto order = static_cast<double>(k);
        even = scaled(-rate * even, 1 / (order * (order + 1)));
        odd = scaled(-rate * odd, 1 / ((order + 1) * (order + 2)));
      }
    }
    series_[0] += plate.steady;
  }

  Scalar start_position_;
  Scalar start_velocity_;
  Scalar elapsed_ = constant<Scalar>(0.0);
  Series<Scalar> series_;  // of the acceleration, from the start
  Scalar acceleration_;
  Scalar jerk_;
  Scalar snap_;
  RampBounds bounds_;
};

}  // namespace ricochet::carrier_track::inline flight
