#pragma once

#include <optional>

#include "src/cli/scene_choice.h"

namespace ricochet::cli {

struct ThresholdOptions {
  SceneChoice scene;
  bool all = false;  ///< every case of the paper
  bool json = false;
  double fastest = 18.0;                 ///< [rad/s], end of the range searched
  std::optional<double> allow;           ///< collisions in the window
  std::optional<double> allow_per_turn;  ///< collisions
  std::optional<double> allow_energy;    ///< [J], in the window
  std::optional<double> allow_speed;     ///< [m/s], of the fastest impact
  double tolerance = 0;                  ///< [%], of every constant
};

/// The fastest quiet speed of a machine: by the limit that is allowed, or by the staircase's own
/// steps. Of the paper's cases the threshold by the paper's rule, and the steps beside it. Returns
/// the exit code.
int threshold(const ThresholdOptions& options);

}  // namespace ricochet::cli
