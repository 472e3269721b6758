#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "problems/carrier_track/flight/flight.h"
#include "problems/carrier_track/flight/plate_forces.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline flight {

/// The applied forces of a scene at constant speed, divided by the mass, at the current time: a
/// steady acceleration and two harmonics, one of the driver plate and one of the disturbance.
template <class Scalar>
class AppliedForces {
 public:
  using Path = Flight<Scalar>;

  explicit AppliedForces(const BasicScene<Scalar>& scene)
      : AppliedForces(scene, plate_forces(scene), disturbance_of(scene)) {}

  /// The forces of equation (22), for the second direction, y, without disturbance. `scene` must
  /// have a second direction.
  static AppliedForces across(const BasicScene<Scalar>& scene) {
    const Scalar zero = constant<Scalar>(0.0);
    return AppliedForces(scene, plate_forces_across(scene),
                         {zero, zero, scene.disturbance_frequency});
  }

  /// The acceleration now [m/s^2].
  Scalar sum() const { return still_.acceleration(); }

  /// The plain value of sum().
  double plain_sum() const { return value(still_.acceleration()); }

  /// The rate of change of sum() [m/s^3].
  Scalar rate() const { return still_.jerk(); }

  /// Sum of the magnitudes that make up sum() [m/s^2]: what its rounding is relative to.
  double size() const { return still_.size(); }

  /// Bound on the magnitude of sum() over all time [m/s^2].
  double strongest() const { return still_.bounds(0).acceleration; }

  /// Bound over all time on the rate of sum() [m/s^3].
  double jerk_bound() const { return still_.bounds(std::numeric_limits<double>::infinity()).jerk; }

  /// How long [s] a flight that starts now is valid.
  Scalar reach() const { return constant<Scalar>(std::numeric_limits<double>::infinity()); }

  /// Free flight from here under these forces and `further`, the steady acceleration of friction.
  Path flight(const Scalar& position, const Scalar& velocity, const Scalar& further) const {
    Path path = still_;
    path.position = position;
    path.velocity = velocity;
    path.steady += further;
    return path;
  }

  /// Lets `time` [s] pass. The harmonics are rotated, so the amplitude stays and no angle grows
  /// without bound.
  void pass(const Scalar& time) {
    Path path = still_;
    path.advance(time);
    arrive(path, time);
  }

  /// Lets `time` [s] pass; `there` is the end of the flight in that time.
  void arrive(const Path& there, const Scalar& /*time*/) { still_.harmonic = there.harmonic; }

 private:
  AppliedForces(const BasicScene<Scalar>& scene, const PlateForces<Scalar>& plate,
                const Harmonic<Scalar>& disturbance) {
    using std::cos;
    using std::sin;
    const Scalar square = scene.omega * scene.omega;
    const Scalar cosine = plate.cosine + plate.square_cosine * square;
    const Scalar sine = plate.sine + plate.square_sine * square;
    const Scalar c = cos(scene.phase);
    const Scalar s = sin(scene.phase);
    still_.steady = plate.steady + plate.square * square;
    // sin alpha is the cosine of an angle a quarter turn behind.
    still_.harmonic[0] = {cosine * c + sine * s, cosine * s - sine * c, scene.omega};
    still_.harmonic[1] = disturbance;
    still_.harmonics = vanishes(disturbance.cosine) && vanishes(disturbance.sine) ? 1 : 2;
  }

  Path still_{};  // of a body at rest at zero
};

}  // namespace ricochet::carrier_track::inline flight
