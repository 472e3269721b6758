#pragma once

#include <array>
#include <vector>

#include "problems/carrier_track/identification/knock_record.h"
#include "problems/carrier_track/identification/knock_unknowns.h"
#include "ricochet/recording.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline identification {

/// An impact that a simulation predicts, with derivatives by the motion's unknowns, i.e. by the
/// first coordinates of a point, see KnockUnknowns. By the lag the time has the slope 1, by the
/// drift the time since the record's start on the clock of the speeds.
struct PredictedImpact {
  double time;       ///< [s], of the record's clock
  double log_speed;  ///< ln of the approach speed [m/s]
  Wall wall = Wall::lower;
  std::array<double, motion_unknowns> time_slopes = {};
  std::array<double, motion_unknowns> log_speed_slopes = {};
};

/// The impacts faster than `slowest` [m/s] of a scene at the unknowns x while a record was made, in
/// order of time. The carrier is let settle for two turns before, at the record's first speed. What
/// the unknowns do not name is the scene's. The scene must be of fidelity impact.
std::vector<PredictedImpact> predicted_impacts(const Scene& scene, const KnockRecord& record,
                                               const Vector& x, double slowest);

/// The same without derivatives, which takes half the time.
std::vector<PredictedImpact> plain_impacts(const Scene& scene, const KnockRecord& record,
                                           const Vector& x, double slowest);

}  // namespace ricochet::carrier_track::inline identification
