#pragma once

#include <optional>
#include <string>

#include "ricochet/regimes.h"
#include "src/cli/scene_choice.h"

namespace ricochet::cli {

struct RegimesOptions {
  SceneChoice scene;
  carrier_track::RegimeOptions range;
  bool json = false;
  double seconds = 60;  ///< time limit
  std::string plot;     ///< SVG file for a chart; empty: none

  std::string over;           ///< CONSTANT=FROM..TO: borders over it; empty: none
  std::optional<int> values;  ///< of that constant
  std::string csv;            ///< CSV file for the points of the borders; empty: none

  std::optional<int> starts;    ///< to sample at one speed
  std::optional<double> omega;  ///< [rad/s], that speed; if missing: the scene's
  carrier_track::BasinOptions sampled = {};
};

}  // namespace ricochet::cli
