#pragma once

#include "problems/carrier_track/scene.h"

namespace ricochet::carrier_track {

/// The applied forces along an axis over the mass, as functions of the driver plate's angle alpha
/// and speed omega; the disturbance is apart:
///   steady + square omega^2 + (cosine + square_cosine omega^2) cos alpha - slope_sine omega' sin
///   alpha.
template <class Scalar>
struct PlateForces {
  Scalar steady;         ///< [m/s^2]
  Scalar square;         ///< [m]
  Scalar cosine;         ///< [m/s^2]
  Scalar square_cosine;  ///< [m]
  Scalar slope_sine;     ///< [m]
};

/// Equation (31) but for contact, friction and disturbance.
template <class Scalar>
PlateForces<Scalar> plate_forces(const BasicScene<Scalar>& scene) {
  const Scalar zero = constant<Scalar>(0.0);
  const Scalar pull = scene.pull / scene.mass;
  const Scalar centrifugal = scene.centrifugal_mass_radius / scene.mass;
  const Scalar slider = scene.slider_mass_radius / scene.mass;
  PlateForces<Scalar> forces{zero, zero, zero, -slider, slider};
  (scene.pull_rotates ? forces.cosine : forces.steady) -= pull;
  switch (scene.centrifugal) {
    case Centrifugal::projected:
      forces.square_cosine += centrifugal;
      break;
    case Centrifugal::inward:
      forces.square -= centrifugal;
      break;
    case Centrifugal::outward:
      forces.square += centrifugal;
      break;
  }
  return forces;
}

}  // namespace ricochet::carrier_track
