#pragma once

#include <optional>
#include <vector>

#include "problems/carrier_track/identification/knock_loss.h"

namespace ricochet::carrier_track::inline identification {

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
