#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "problems/carrier_track/motion/flight.h"
#include "problems/carrier_track/motion/harmonic.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline flight {

/// The applied forces along an axis divided by the mass, without the disturbance, as functions of
/// the driver plate's angle alpha, its speed omega and omega':
///   steady + square omega^2
///   + (cosine + square_cosine omega^2 + slope_cosine omega') cos alpha
///   + (sine + square_sine omega^2 + slope_sine omega') sin alpha.
template <class Scalar>
struct PlateForces {
  Scalar steady = constant<Scalar>(0.0);         ///< [m/s^2]
  Scalar square = constant<Scalar>(0.0);         ///< [m]
  Scalar cosine = constant<Scalar>(0.0);         ///< [m/s^2]
  Scalar square_cosine = constant<Scalar>(0.0);  ///< [m]
  Scalar slope_cosine = constant<Scalar>(0.0);   ///< [m]
  Scalar sine = constant<Scalar>(0.0);           ///< [m/s^2]
  Scalar square_sine = constant<Scalar>(0.0);    ///< [m]
  Scalar slope_sine = constant<Scalar>(0.0);     ///< [m]
};

/// The forces of equation (31) without contact, friction and disturbance.
template <class Scalar>
PlateForces<Scalar> plate_forces(const BasicScene<Scalar>& scene) {
  using std::cos;
  using std::sin;
  const Scalar pull = scene.pull / scene.mass;
  const Scalar centrifugal = scene.centrifugal_mass_radius / scene.mass;
  const Scalar slider = scene.slider_mass_radius / scene.mass;
  PlateForces<Scalar> forces;
  forces.square_cosine = forces.slope_sine = -slider;
  if (scene.pull_rotates) {
    forces.cosine = -pull * cos(scene.pull_phase);
    forces.sine = pull * sin(scene.pull_phase);
  } else {
    forces.steady = -pull;
  }
  switch (scene.centrifugal) {
    case Centrifugal::projected:
      forces.square_cosine += centrifugal;
      break;
    case Centrifugal::inward:
      forces.square = -centrifugal;
      break;
    case Centrifugal::outward:
      forces.square = centrifugal;
      break;
  }
  return forces;
}

/// The disturbance of equation (31) divided by the mass, at time 0.
template <class Scalar>
Harmonic<Scalar> disturbance_of(const BasicScene<Scalar>& scene) {
  using std::cos;
  using std::sin;
  const Scalar amplitude = scene.disturbance / scene.mass;
  return {amplitude * cos(scene.disturbance_phase), amplitude * sin(scene.disturbance_phase),
          scene.disturbance_frequency};
}

/// The forces of equation (22) without contact and friction; the scene must have a second
/// direction, y.
template <class Scalar>
PlateForces<Scalar> plate_forces_across(const BasicScene<Scalar>& scene) {
  using std::cos;
  using std::sin;
  const Scalar slider = scene.slider_mass_radius / scene.mass;
  PlateForces<Scalar> forces;
  forces.steady = scene.across.value().pull / scene.mass;
  if (scene.pull_rotates) {
    forces.sine = scene.pull / scene.mass * cos(scene.pull_phase);
    forces.cosine = scene.pull / scene.mass * sin(scene.pull_phase);
  }
  forces.square_sine = slider;
  forces.slope_cosine = -slider;
  return forces;
}

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

/// The driver plate at one moment while its speed changes linearly. Scalar may also be a vector of
/// derivatives.
template <class Scalar>
struct PlateRamp {
  Scalar angle{};  ///< [rad]
  Scalar speed{};  ///< [rad/s]
  Scalar slope{};  ///< of the speed [rad/s^2]

  /// After a time [s].
  template <class Time>
  PlateRamp after(const Time& t) const {
    const Scalar gain = slope * t;
    return {angle + (speed + 0.5 * gain) * t, speed + gain, slope};
  }
};

/// The acceleration [m/s^2] by the plate.
template <class Scalar>
Scalar acceleration_of(const PlateForces<double>& plate, const PlateRamp<Scalar>& ramp) {
  using std::cos;
  using std::sin;
  const Scalar square = ramp.speed * ramp.speed;
  const Scalar cosine =
      plate.cosine + plate.square_cosine * square + plate.slope_cosine * ramp.slope;
  const Scalar sine = plate.sine + plate.square_sine * square + plate.slope_sine * ramp.slope;
  return plate.steady + plate.square * square + cosine * cos(ramp.angle) + sine * sin(ramp.angle);
}

/// A harmonic a time [s] later.
template <class Scalar>
Harmonic<Scalar> after(const Harmonic<double>& harmonic, const Scalar& time) {
  using std::cos;
  using std::sin;
  const Scalar c = cos(harmonic.frequency * time);
  const Scalar s = sin(harmonic.frequency * time);
  return {harmonic.cosine * c - harmonic.sine * s, harmonic.sine * c + harmonic.cosine * s,
          Scalar(harmonic.frequency)};
}

/// The applied forces while the driver plate's speed changes linearly, at one moment.
template <class Scalar>
struct RampForces {
  PlateForces<Scalar> plate;
  Harmonic<Scalar> disturbance;
  Scalar alpha;  ///< [rad]
  Scalar omega;  ///< [rad/s]
  Scalar slope;  ///< of omega [rad/s^2]
};

/// The range in which a power series of these forces is valid, and bounds on the forces there.
struct RampBounds {
  double reach = 0;    ///< [s], about a third of a radian
  double size = 0;     ///< upper bound on the sum of the magnitudes of its terms [m/s^2]
  ForceBounds forces;  ///< over the reach
};

template <class Scalar>
RampBounds bounds_of(const RampForces<Scalar>& forces) {
  const double slope = std::abs(value(forces.slope));
  const double frequency = value(forces.disturbance.frequency);
  const double disturbance =
      std::hypot(value(forces.disturbance.cosine), value(forces.disturbance.sine));
  const bool swings = !vanishes(forces.disturbance.cosine) || !vanishes(forces.disturbance.sine);
  double omega = value(forces.omega);
  const double fastest = std::fmax(std::fmax(omega, swings ? frequency : 0.0), std::sqrt(slope));
  const double reach = fastest > 0 ? 0.3 / fastest : std::numeric_limits<double>::infinity();
  omega += fastest > 0 ? slope * reach : 0.0;
  const auto& plate = forces.plate;
  const double steady = std::abs(value(plate.steady));
  const double square = std::abs(value(plate.square));
  const double still = std::hypot(value(plate.cosine), value(plate.sine)) +
                       slope * std::hypot(value(plate.slope_cosine), value(plate.slope_sine));
  const double squared = std::hypot(value(plate.square_cosine), value(plate.square_sine));
  const double turning = still + squared * omega * omega;
  const double turning_rate = 2 * squared * omega * slope;
  const double size = steady + square * omega * omega + turning + disturbance;
  return {
      reach,
      size,
      {size, 2 * square * omega * slope + turning * omega + turning_rate + disturbance * frequency,
       2 * square * slope * slope + turning * (omega * omega + slope) + 2 * turning_rate * omega +
           2 * squared * slope * slope + disturbance * frequency * frequency,
       fastest > 0 ? 1e-8 / fastest : 0.0}};
}

}  // namespace ricochet::carrier_track::inline flight
