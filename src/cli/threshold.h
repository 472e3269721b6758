#pragma once

#include <optional>

#include "src/cli/scene_choice.h"

namespace ricochet::cli {

struct ThresholdOptions {
  SceneChoice scene;
  bool all = false;  ///< every case of the paper
  bool json = false;
  double fastest = 18.0;  ///< [rad/s], end of the range searched
};

/// The threshold of one scene or of all cases, with all parts of the score. Returns the exit code.
int threshold(const ThresholdOptions& options);

}  // namespace ricochet::cli
