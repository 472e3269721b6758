#pragma once

#include <cmath>
#include <limits>

#include "problems/carrier_track/flight/flight.h"
#include "problems/carrier_track/flight/plate_forces.h"

namespace ricochet::carrier_track::inline flight {

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
