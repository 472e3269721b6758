#pragma once

#include <optional>
#include <vector>

#include "ricochet/machine.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline regimes {

/// The collisions of a window: which are the start's decay, which the motion in the long run.
struct Anatomy {
  std::vector<bool> in_the_long_run;  ///< of every impact, whether the long run has it, too
  int of_start = 0;                   ///< collisions that do not come again
  int of_long_run = 0;                ///< collisions that come again in every period
  double per_turn = 0;                ///< collisions a turn in the long run
};

/// The anatomy of a valid scene's window with these impacts. An impact belongs to the long run if
/// that has one at the same angle of the driver plate (to 1e-6 rad), on the same wall, with the
/// same speed (to 1e-6, relative). Nothing if the motion does not settle on a period, or if the
/// scene has no regimes (check_regimes_exist) or no constant speed.
std::optional<Anatomy> anatomy_of(const Scene& scene, const std::vector<Impact>& impacts);

}  // namespace ricochet::carrier_track::inline regimes
