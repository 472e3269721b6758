#pragma once

#include <string>

#include "ricochet/regimes.h"
#include "src/cli/scene_choice.h"

namespace ricochet::cli {

struct RegimesOptions {
  SceneChoice scene;
  carrier_track::RegimeOptions range;
  bool json = false;
  std::string plot;  ///< SVG file for collisions a turn over the speed; empty: none
};

/// Prints what the carrier of a machine does in the long run, from border to border. Returns the
/// exit code.
int regimes(const RegimesOptions& options);

}  // namespace ricochet::cli
