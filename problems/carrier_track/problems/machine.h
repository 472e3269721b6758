#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/problems/cases.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline problems {

/// A machine at any speed, from which problems are made.
struct Machine {
  std::string id;                   ///< of the case, e.g. "C1", or "scene"
  Scene scene;                      ///< valid; its own speed is not used
  double quiet_limit = 0;           ///< a count up to this is quiet
  std::optional<double> threshold;  ///< [rad/s] as claimed, or found if there is no claim
  std::string default_hash;         ///< default_machine_hash() for the suite's cases; else empty
};

/// A case with these constants; the quiet limit is that of its claim.
Machine machine_of(const Case& a_case, const Scene& constants);

/// A machine "scene" from the user's file; limit and threshold are of quiet_rule_of(). `origin`
/// names the scene, for instance its file. Throws InputError for a speed profile: a threshold is
/// defined for constant speeds.
Machine machine_of(const Scene& scene, const std::string& origin);

/// The cases of the default machine.
std::vector<Machine> all_machines();

/// [rad/s]; a speed at which the machine is probably loud: 1.25 thresholds, or 6 rad/s without a
/// threshold.
inline double loud_speed(const Machine& machine) {
  return machine.threshold ? 1.25 * *machine.threshold : 6.0;
}

/// The level at which a smooth surrogate is compared with the quiet limit: half a collision above
/// the highest quiet count. Counts are integers, and an impact counts half at margin 0: so the
/// surrogate crosses this level, apart from the tails of other impacts, exactly where the count
/// leaves the limit.
inline double half_level(double quiet_limit) {
  return std::floor(quiet_limit) + 0.5;
}

/// Returns true if simulations of the scene can carry derivatives: those with hard walls in one
/// direction can.
inline bool carries_derivatives(const Scene& scene) {
  return scene.fidelity == Fidelity::impact;
}

}  // namespace ricochet::carrier_track::inline problems
