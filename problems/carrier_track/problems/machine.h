#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/paper/cases.h"
#include "problems/carrier_track/scene/scene.h"

namespace ricochet::carrier_track::inline questions {

/// What problems are put to: a machine whose speed is open.
struct Machine {
  std::string id;                   ///< of the case, e.g. "C1", or "scene"
  Scene scene;                      ///< valid; its own speed is not used
  double quiet_limit = 0;           ///< counts up to here are quiet
  std::optional<double> threshold;  ///< [rad/s] as claimed, or found where nobody can claim it
  std::string reading;              ///< of the paper, where it is the default; else empty
};

/// A case in some reading's scene; the quiet limit is that of its claim.
Machine machine_of(const Case& a_case, const Scene& reading);

/// A machine of the user's own, "scene"; limit and threshold as `ricochet threshold` finds them,
/// without a claim. `origin` names the scene, for instance its file. Throws InputError for a speed
/// profile: a threshold is of constant speeds.
Machine machine_of(const Scene& scene, const std::string& origin);

/// The cases in the default reading.
std::vector<Machine> all_machines();

/// [rad/s]; a speed at which the machine is loud, if anything: 1.25 thresholds, or 6 rad/s where
/// there is none.
inline double loud_speed(const Machine& machine) {
  return machine.threshold ? 1.25 * *machine.threshold : 6.0;
}

/// Where a smooth surrogate is compared with the quiet limit: half a collision above the highest
/// quiet count. A count is whole, and an impact counts half where its margin is 0: so the surrogate
/// passes this level, but for the other impacts' tails, just where the count leaves the limit.
inline double half_level(double quiet_limit) {
  return std::floor(quiet_limit) + 0.5;
}

/// Whether simulations of the scene carry derivatives: hard walls in one direction do.
inline bool carries_derivatives(const Scene& scene) {
  return scene.fidelity == Fidelity::impact;
}

}  // namespace ricochet::carrier_track::inline questions
