#pragma once

#include <string>

#include "src/cli/quiet_speed_request.h"
#include "src/cli/scene_choice.h"

namespace ricochet::cli {

struct ThresholdOptions {
  SceneChoice scene;
  bool all = false;  ///< every case of the paper
  bool json = false;
  std::string plot;  ///< SVG file for the staircase; empty: none
  QuietSpeedRequest asked;
};

/// Prints the fastest quiet speed of a machine, from its regimes in the long run or by a limit of
/// its window. For the paper's cases it prints the threshold by the paper's rule, too. Returns the
/// exit code.
int threshold(const ThresholdOptions& options);

}  // namespace ricochet::cli
