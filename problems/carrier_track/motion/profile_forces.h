#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "problems/carrier_track/motion/ramp_flight.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline flight {

/// The flight under a speed profile; for a dual scalar the one with fast derivatives.
template <class Scalar>
struct PathUnderProfile {
  using Path = RampFlight<Scalar>;
};
template <Dual Scalar>
struct PathUnderProfile<Scalar> {
  using Path = DualRampFlight<Scalar>;
};

/// The applied forces of a scene with a speed profile, divided by the mass, at the current time.
/// Between knots the speed of the driver plate changes linearly. The same concept as AppliedForces.
template <class Scalar>
class ProfileForces {
 public:
  using Path = typename PathUnderProfile<Scalar>::Path;

  explicit ProfileForces(const BasicScene<Scalar>& scene)
      : ProfileForces(scene, plate_forces(scene), disturbance_of(scene)) {}

  /// The forces of equation (22), for the second direction, y, without disturbance. `scene` must
  /// have a second direction.
  static ProfileForces across(const BasicScene<Scalar>& scene) {
    const Scalar zero = constant<Scalar>(0.0);
    return ProfileForces(scene, plate_forces_across(scene),
                         {zero, zero, scene.disturbance_frequency});
  }

  /// The acceleration now [m/s^2].
  Scalar sum() const { return still_.acceleration(); }

  /// The plain value of sum().
  double plain_sum() const { return still_.plain_acceleration(); }

  /// The rate of change of sum() [m/s^3].
  Scalar rate() const { return still_.jerk(); }

  /// Upper bound on the sum of the magnitudes that make up sum() [m/s^2].
  double size() const { return still_.size(); }

  /// Bound on the magnitude of sum() over all time [m/s^2].
  double strongest() const {
    RampForces<Scalar> forces = now_;
    double strongest = 0;
    for (std::size_t k = 0; k < knots().size(); ++k) {
      forces.omega = knots()[k].omega;
      for (const std::size_t end : {k, k + 1}) {
        forces.slope = slope_to(end);
        strongest = std::max(strongest, bounds_of(forces).size);
      }
    }
    return strongest;
  }

  /// Bound over the reach on the rate of sum() [m/s^3].
  double jerk_bound() const { return still_.jerk_bound(); }

  /// How long [s] a flight that starts now is valid.
  Scalar reach() const {
    const double good = still_.reach();
    const Scalar left = left_of_leg();
    return good < value(left) ? constant<Scalar>(good) : left;
  }

  /// Free flight from here under these forces and `further`, the steady acceleration of friction.
  Path flight(const Scalar& position, const Scalar& velocity, const Scalar& further) const {
    Path path = still_;
    path.start(position, velocity);
    path.push(further);
    return path;
  }

  /// Lets `time` [s] pass.
  void pass(Scalar time) {
    while (value(time) >= value(left_of_leg())) {
      const Scalar left = left_of_leg();
      turn(left);
      time -= left;
      ++next_;
      begin_leg();
    }
    turn(time);
    still_ = still();
  }

  /// Lets `time` [s] pass, the duration of a flight.
  void arrive(const Path& /*there*/, const Scalar& time) { pass(time); }

 private:
  ProfileForces(const BasicScene<Scalar>& scene, const PlateForces<Scalar>& plate,
                const Harmonic<Scalar>& disturbance)
      : knots_(&scene.profile),
        now_{plate, disturbance, scene.phase, scene.profile.front().omega, slope_to(0)},
        still_(still()) {
    // A body at rest at a knot is pushed as after it.
    if (value(left_of_leg()) == 0) pass(constant<Scalar>(0.0));
  }

  const std::vector<SpeedKnot<Scalar>>& knots() const { return *knots_; }

  Path still() const {
    const Scalar zero = constant<Scalar>(0.0);
    return Path(zero, zero, now_);
  }

  /// Slope of omega [rad/s^2] between the knot before `knot` and `knot`; 0 before the first and
  /// after the last knot.
  Scalar slope_to(std::size_t knot) const {
    if (knot == 0 || knot >= knots().size()) return constant<Scalar>(0.0);
    return (knots()[knot].omega - knots()[knot - 1].omega) *
           constant<Scalar>(1 / (knots()[knot].time - knots()[knot - 1].time));
  }

  Scalar left_of_leg() const {
    if (next_ == knots().size()) return constant<Scalar>(std::numeric_limits<double>::infinity());
    return constant<Scalar>(knots()[next_].time) - time_;
  }

  void begin_leg() {
    if (next_ > 0) now_.omega = knots()[next_ - 1].omega;
    now_.slope = slope_to(next_);
  }

  void turn(const Scalar& time) {
    time_ += time;
    const Scalar gain = now_.slope * time;
    now_.alpha += time * (now_.omega + scaled(gain, 0.5));
    const double turn = 2 * std::numbers::pi;
    now_.alpha -= constant<Scalar>(turn * std::floor(value(now_.alpha) / turn));
    now_.omega += gain;
    auto& disturbance = now_.disturbance;
    if (vanishes(disturbance.cosine) && vanishes(disturbance.sine)) return;
    const Swung<Scalar> by = swung(disturbance, time);
    disturbance.cosine = by.cosine;
    disturbance.sine = by.sine;
  }

  const std::vector<SpeedKnot<Scalar>>* knots_;  // of the scene
  std::size_t next_ = 0;                         // knot
  Scalar time_ = constant<Scalar>(0.0);
  RampForces<Scalar> now_;
  Path still_;  // of a body at rest at zero, from now
};

}  // namespace ricochet::carrier_track::inline flight
