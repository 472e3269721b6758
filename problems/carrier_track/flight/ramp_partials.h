#pragma once

#include <cstddef>

#include "problems/carrier_track/flight/plate_forces.h"
#include "problems/carrier_track/flight/rotation_taylor.h"

namespace ricochet::carrier_track::inline flight {

/// The partial derivatives of the plate's acceleration along a flight with respect to the angle,
/// the speed and the slope of the speed at the start of the flight, as series in time.
///
/// With t the time from the start, f(alpha, omega, slope) the plate's force at any time and F(t)
/// that of this flight:
///   dF/d alpha = df/d alpha,  dF/d omega = t df/d alpha + df/d omega,
///   dF/d slope = t^2 / 2 df/d alpha + t df/d omega + df/d slope.
template <class Scalar>
struct RampPartials {
  Series<Scalar> by_alpha;  ///< [m/s^2 per rad], coefficients of powers of time [s]
  Series<Scalar> by_omega;  ///< [m/s^2 per rad/s]
  Series<Scalar> by_slope;  ///< [m/s^2 per rad/s^2]

  /// `turning` is the series of this speed and slope. Constant is Scalar or double.
  template <class Constant>
  RampPartials(const PlateForces<Constant>& plate, const Scalar& omega, const Scalar& slope,
               const RotationTaylor<Scalar>& turning) {
    const Scalar cosine = plate.cosine + plate.slope_cosine * slope;
    const Scalar sine = plate.sine + plate.slope_sine * slope;
    Scalar by_omega_before = constant<Scalar>(0.0);
    Scalar growth_before = by_omega_before;
    for (std::size_t k = 0; k < series_terms; ++k) {
      // df/d omega is 2 omega times this.
      Scalar growth = plate.square_cosine * turning.cosine[k] + plate.square_sine * turning.sine[k];
      if (k == 0) growth += plate.square;
      Scalar along = omega * growth;
      if (k > 0) along += slope * growth_before;
      along = scaled(along, 2);
      by_alpha[k] = sine * turning.cosine[k] + plate.square_sine * turning.square_cosine[k] -
                    cosine * turning.sine[k] - plate.square_cosine * turning.square_sine[k];
      by_omega[k] = along;
      by_slope[k] = plate.slope_cosine * turning.cosine[k] + plate.slope_sine * turning.sine[k];
      if (k > 0) {
        by_omega[k] += by_alpha[k - 1];
        by_slope[k] += by_omega_before;
      }
      if (k > 1) by_slope[k] += scaled(by_alpha[k - 2], 0.5);
      by_omega_before = along;
      growth_before = growth;
    }
  }
};

}  // namespace ricochet::carrier_track::inline flight
