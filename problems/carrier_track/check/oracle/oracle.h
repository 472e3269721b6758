#pragma once

#include <vector>

#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/scene/scene.h"

namespace ricochet::carrier_track::inline oracle {

/// Where a rising body comes to a stop without reaching the upper wall.
struct Summit {
  double time;         ///< [s]
  long double height;  ///< [m] above the lower wall
};

/// What the oracle makes of a scene.
struct OracleRun {
  int count = 0;                ///< of the scene's rule, up to the end or the cap
  bool finished = true;         ///< whether the end of the window was reached within the caps
  std::vector<Impact> impacts;  ///< in the order of time; those of the end of a Zeno sequence apart
  std::vector<Summit> summits;
  std::vector<Peak> maxima;  ///< of x, on a wall too; those of the end of a Zeno sequence apart
  bool endless = false;      ///< whether those apart count, of which there is no end: count is none
};

/// A run is broken off at so many impacts: beyond, its window holds no useful count.
inline constexpr std::size_t oracle_impact_cap = 2000;

/// Simulates fidelity `impact` at constant omega, for a valid scene: hard walls, Newton
/// restitution, set-valued Coulomb friction. Independent of the impact model, of which it shares
/// neither code nor method: long double of 80 bit, the closed forms of push.h, and roots isolated
/// by first_fall.h. A grazing is decided by the distance to the wall at the very turning point. The
/// rest of a Zeno sequence is left out only when it is proved that the body comes to rest on the
/// wall before the force turns, with no impact faster than a thousandth of `slowest`, and where
/// maxima count before the window ends. Throws std::invalid_argument for a scene with a speed
/// profile.
OracleRun oracle_run(const Scene& scene);

}  // namespace ricochet::carrier_track::inline oracle
