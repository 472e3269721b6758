#pragma once

#include <string>

#include "src/cli/quiet_speed_request.h"
#include "src/cli/scene_choice.h"

namespace ricochet::cli {

struct ThresholdOptions {
  SceneChoice scene;
  bool all = false;  ///< every case of the paper
  bool json = false;
  std::string plot;  ///< SVG file for the staircase, empty for none
  QuietSpeedRequest asked;
};

/// The fastest quiet speed of a machine: by the limit that is allowed, or by the staircase's own
/// steps. Of the paper's cases the threshold by the paper's rule, and the steps beside it. Returns
/// the exit code.
int threshold(const ThresholdOptions& options);

}  // namespace ricochet::cli
