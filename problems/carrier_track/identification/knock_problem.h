#pragma once

#include <optional>
#include <vector>

#include "problems/carrier_track/identification/knock_loss.h"
#include "ricochet/problem.h"

namespace ricochet::carrier_track::inline identification {

/// The nearest point to x within the limits of a search: beyond them there is no machine, or a
/// simulation takes very long. Restitution is at most 0.982.
Vector within_limits(const Vector& x);

/// Coordinates z of the unknowns that are fitted, in which a step of 1 in any direction is one
/// standard deviation, as the information at the centre z = 0 has it: solvers need no scaling.
struct KnockCoordinates {
  Vector centre;      ///< of length knock_unknowns
  Matrix directions;  ///< knock_unknowns x n

  /// The point of the unknowns at z (length n), within_limits().
  Vector at(const Vector& z) const { return within_limits(centre + directions * z); }
};

/// The coordinates of these unknowns, by their indices; the others keep their values of `centre`.
KnockCoordinates knock_coordinates(const KnockLoss& loss, const Vector& centre, double blur,
                                   const std::vector<Eigen::Index>& free);

/// To minimise a loss of this blur [rad] over z, within `reach` deviations. Both must outlive it.
Problem knock_problem(const KnockLoss& loss, const KnockCoordinates& coordinates, double blur,
                      double reach = 10);

/// What a further step of a record, at one speed, would leave uncertain.
struct NextSpeed {
  double omega;      ///< [rad/s]
  double deviation;  ///< the standard deviation of the target after it
  double now;        ///< the same before it
};

/// How long [s] the further step lasts.
inline constexpr double next_step_seconds = 20;

/// The speed, of a grid from a third of the slowest to twice the fastest speed of the record and at
/// most `fastest` [rad/s], that leaves least uncertain the sum of `target` times the first
/// coordinates of x. The step continues the record, so it shares the plate's angle. `x` is the best
/// point, with its information and score covariance (KnockLoss::information). Speeds whose impacts
/// depend ever more on how the step began, as in chaotic motion, are left out.
std::optional<NextSpeed> next_speed(const KnockLoss& loss, const Vector& x, const Vector& target,
                                    double fastest);

/// The covariance of an estimate at which the loss has this information and score covariance.
Matrix covariance_of(const KnockDensity::Information& information,
                     const std::vector<Eigen::Index>& free);

}  // namespace ricochet::carrier_track::inline identification
