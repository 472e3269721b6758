#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "problems/carrier_track/ramp_flight.h"
#include "problems/carrier_track/scene.h"

namespace ricochet::carrier_track {

/// The applied forces of a scene with a speed profile, as they are at the present time: from knot
/// to knot the driver plate speeds up or slows down steadily. The same concept as AppliedForces.
template <class Scalar>
class ProfileForces {
 public:
  using Path = RampFlight<Scalar>;

  explicit ProfileForces(const BasicScene<Scalar>& scene)
      : ProfileForces(scene, plate_forces(scene), disturbance_of(scene)) {}

  /// The same of equation (22), for the second direction, y; `scene` must have one. It has no
  /// disturbance.
  static ProfileForces across(const BasicScene<Scalar>& scene) {
    const Scalar zero = constant<Scalar>(0.0);
    return ProfileForces(scene, plate_forces_across(scene),
                         {zero, zero, scene.disturbance_frequency});
  }

  /// The acceleration now [m/s^2].
  Scalar sum() const { return still().acceleration(); }

  /// Sum of the magnitudes that make up sum() [m/s^2], or more.
  double size() const { return still().size(); }

  /// Bound on the magnitude of sum() over all time [m/s^2].
  double strongest() const {
    RampForces<Scalar> forces = now_;
    double strongest = 0;
    for (std::size_t k = 0; k < knots().size(); ++k) {
      forces.omega = knots()[k].omega;
      for (const std::size_t end : {k, k + 1}) {
        forces.slope = slope_to(end);
        const Scalar zero = constant<Scalar>(0.0);
        strongest = std::max(strongest, Path(zero, zero, forces).size());
      }
    }
    return strongest;
  }

  /// Bound over the reach on the rate of sum() [m/s^3].
  double jerk_bound() const { return still().jerk_bound(); }

  /// How long [s] a flight from here is good for.
  Scalar reach() const {
    const double good = still().reach();
    const Scalar left = left_of_leg();
    return good < value(left) ? constant<Scalar>(good) : left;
  }

  /// Free flight from here under these forces and a further steady acceleration, of friction.
  Path flight(const Scalar& position, const Scalar& velocity, const Scalar& further) const {
    Path path(position, velocity, now_);
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
  }

  /// Lets `time` [s] pass, in which a flight has come there.
  void arrive(const Path& /*there*/, const Scalar& time) { pass(time); }

 private:
  ProfileForces(const BasicScene<Scalar>& scene, const PlateForces<Scalar>& plate,
                const Harmonic<Scalar>& disturbance)
      : knots_(&scene.profile),
        now_{plate, disturbance, scene.phase, scene.profile.front().omega, constant<Scalar>(0.0)} {
    begin_leg();
  }

  const std::vector<SpeedKnot<Scalar>>& knots() const { return *knots_; }

  Path still() const {
    const Scalar zero = constant<Scalar>(0.0);
    return flight(zero, zero, zero);
  }

  /// Slope of omega [rad/s^2] on the leg that ends at a knot; after the last the speed holds.
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
    const Scalar half = constant<Scalar>(0.5);
    time_ += time;
    now_.alpha += time * (now_.omega + half * now_.slope * time);
    const double turn = 2 * std::numbers::pi;
    now_.alpha -= constant<Scalar>(turn * std::floor(value(now_.alpha) / turn));
    now_.omega += now_.slope * time;
    const Scalar zero = constant<Scalar>(0.0);
    Flight<Scalar> swinging{zero, zero, zero, {now_.disturbance, {}}, 1};
    swinging.advance(time);
    now_.disturbance = swinging.harmonic[0];
  }

  const std::vector<SpeedKnot<Scalar>>* knots_;  // of the scene
  std::size_t next_ = 0;                         // knot
  Scalar time_ = constant<Scalar>(0.0);
  RampForces<Scalar> now_;
};

}  // namespace ricochet::carrier_track
