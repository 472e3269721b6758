#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "problems/carrier_track/flight/flight.h"
#include "problems/carrier_track/flight/ramp_flight.h"
#include "problems/carrier_track/flight/ramp_forces.h"
#include "problems/carrier_track/flight/ramp_partials.h"
#include "problems/carrier_track/flight/rotation_taylor.h"

namespace ricochet::carrier_track::inline flight {

/// The RampFlight of a dual scalar, without power series of duals. The flight and its partial
/// derivatives with respect to the few quantities that define it are series in the arithmetic of
/// `Inner`, which is double or a dual of one order less. An evaluation multiplies each partial
/// derivative by the derivatives of its quantity (chain rule).
template <Dual Scalar>
class DualRampFlight {
  using Real = Inner<Scalar>;
  using Tangent = decltype(Scalar::v);
  using Turning = RotationTaylor<Real>;

 public:
  Scalar position;  ///< [m] now
  Scalar velocity;  ///< [m/s] now

  /// A flight that starts now.
  DualRampFlight(const Scalar& start_position, const Scalar& start_velocity,
                 const RampForces<Scalar>& forces)
      : DualRampFlight(start_position, start_velocity, forces,
                       Turning(forces.alpha.a, forces.omega.a, forces.slope.a)) {}

  RampFlight<double> plain() const { return flight_.plain(); }

  const RampFlight<Inner<Scalar>>& inner() const { return flight_; }  ///< see Flight

  /// Exact up to rounding at any t [s] from now, within the reach.
  Motion<Scalar> at(const Scalar& t) const {
    DualRampFlight there = *this;
    there.advance(t);
    return {there.position, there.velocity, there.acceleration()};
  }

  /// Restarts from another position and velocity under the same forces.
  void start(const Scalar& from, const Scalar& with) {
    position = from;
    velocity = with;
    start_position_ = from.v;
    start_velocity_ = with.v;
    flight_.start(from.a, with.a);
  }

  /// Moves the origin of the position by -`by` [m].
  void shift(const Scalar& by) {
    position += by;
    start_position_ += by.v;
    flight_.shift(by.a);
  }

  /// Adds a steady acceleration [m/s^2].
  void push(const Scalar& by) {
    steady_ += by.v;
    flight_.push(by.a);
  }

  /// Lets `t` [s] pass.
  void advance(const Scalar& t) {
    flight_.advance(t.a);
    elapsed_ += t;
    const Real& time = elapsed_.a;
    const Real half = scaled(time * time, 0.5);
    position.a = flight_.position;
    velocity.a = flight_.velocity;
    position.v = start_position_ + start_velocity_ * time + steady_ * half;
    velocity.v = start_velocity_ + steady_ * time;
    for_each_partial([&](const Series<Real>& partial, const Tangent& tangent) {
      const Motion<Real> by = integrals(partial, time);
      position.v += tangent * (time * time * by.position);
      velocity.v += tangent * (time * by.velocity);
    });
    if (disturbance_) {
      const Swung<Scalar> by = swung(*disturbance_, Scalar(time));
      position.v += by.position.v;
      velocity.v += by.velocity.v;
    }
    if (!is_constant(elapsed_)) shift_time_derivative(elapsed_.v);
  }

  /// See Flight. Changes only position and velocity.
  void shift_time_derivative(const Tangent& t) {
    position.v += t * velocity.a;
    velocity.v += t * flight_.acceleration();
  }

  /// The second derivative of the position [m/s^2] now.
  Scalar acceleration() const {
    const Real& time = elapsed_.a;
    Scalar sum(flight_.acceleration());
    sum.v = steady_ + elapsed_.v * flight_.jerk();
    for_each_partial([&](const Series<Real>& partial, const Tangent& tangent) {
      sum.v += tangent * integrals(partial, time).acceleration;
    });
    if (disturbance_) sum.v += swung(*disturbance_, Scalar(time)).cosine.v;
    return sum;
  }

  double plain_acceleration() const { return value(flight_.acceleration()); }
  const Real& inner_acceleration() const { return flight_.acceleration(); }
  Scalar jerk() const {
    return Scalar(flight_.jerk());
  }  ///< [m/s^3], without the outermost derivatives

  double reach() const { return flight_.reach(); }            ///< see RampFlight
  double size() const { return flight_.size(); }              ///< see RampFlight
  double jerk_bound() const { return flight_.jerk_bound(); }  ///< see RampFlight

 private:
  /// The derivatives of the plate's forces themselves, except those of the slope.
  struct Plate {
    Turning turning;
    Tangent steady, square, cosine, square_cosine, sine, square_sine;

    Plate(const RampForces<Scalar>& forces, const Turning& series) : turning(series) {
      const auto& plate = forces.plate;
      const Real& slope = forces.slope.a;
      steady = plate.steady.v;
      square = plate.square.v;
      cosine = plate.cosine.v + plate.slope_cosine.v * slope;
      square_cosine = plate.square_cosine.v;
      sine = plate.sine.v + plate.slope_sine.v * slope;
      square_sine = plate.square_sine.v;
    }
  };

  DualRampFlight(const Scalar& start_position, const Scalar& start_velocity,
                 const RampForces<Scalar>& forces, const Turning& turning)
      : position(start_position),
        velocity(start_velocity),
        start_position_(start_position.v),
        start_velocity_(start_velocity.v),
        alpha_(forces.alpha.v),
        omega_(forces.omega.v),
        slope_(forces.slope.v),
        flight_(start_position.a, start_velocity.a, inner(forces), turning),
        partials_(inner(forces).plate, forces.omega.a, forces.slope.a, turning) {
    if (varies(forces.plate)) plate_.emplace(forces, turning);
    const auto& disturbance = forces.disturbance;
    if (!vanishes(disturbance.cosine) || !vanishes(disturbance.sine)) disturbance_ = disturbance;
  }

  static RampForces<Real> inner(const RampForces<Scalar>& forces) {
    const auto& [plate, disturbance, alpha, omega, slope] = forces;
    return {{plate.steady.a, plate.square.a, plate.cosine.a, plate.square_cosine.a,
             plate.slope_cosine.a, plate.sine.a, plate.square_sine.a, plate.slope_sine.a},
            {disturbance.cosine.a, disturbance.sine.a, disturbance.frequency.a},
            alpha.a,
            omega.a,
            slope.a};
  }

  static bool varies(const PlateForces<Scalar>& plate) {
    for (const Scalar* part :
         {&plate.steady, &plate.square, &plate.cosine, &plate.square_cosine, &plate.slope_cosine,
          &plate.sine, &plate.square_sine, &plate.slope_sine}) {
      if (!is_constant(*part)) return true;
    }
    return false;
  }

  /// Calls `use` with the derivatives of every quantity and the series of the acceleration's
  /// partial derivative with respect to it.
  template <class Use>
  void for_each_partial(Use use) const {
    use(partials_.by_alpha, alpha_);
    use(partials_.by_omega, omega_);
    use(partials_.by_slope, slope_);
    if (!plate_) return;
    Series<Real> one;
    Series<Real> square;
    one.fill(constant<Real>(0.0));
    square.fill(constant<Real>(0.0));
    one[0] = constant<Real>(1.0);
    for (std::size_t k = 0; k < 3; ++k) square[k] = plate_->turning.square[k];
    use(one, plate_->steady);
    use(square, plate_->square);
    use(plate_->turning.cosine, plate_->cosine);
    use(plate_->turning.square_cosine, plate_->square_cosine);
    use(plate_->turning.sine, plate_->sine);
    use(plate_->turning.square_sine, plate_->square_sine);
  }

  Tangent start_position_, start_velocity_;
  Tangent steady_ = constant<Scalar>(0.0).v;  // what was pushed
  Tangent alpha_, omega_, slope_;
  RampFlight<Real> flight_;
  RampPartials<Real> partials_;
  std::optional<Plate> plate_;
  std::optional<Harmonic<Scalar>> disturbance_;
  Scalar elapsed_ = constant<Scalar>(0.0);
};

}  // namespace ricochet::carrier_track::inline flight
