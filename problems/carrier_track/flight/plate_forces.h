#pragma once

#include <cmath>

#include "problems/carrier_track/flight/flight.h"
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

}  // namespace ricochet::carrier_track::inline flight
