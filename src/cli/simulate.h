#pragma once

#include <optional>
#include <string>

#include "src/cli/scene_choice.h"

namespace ricochet::cli {

struct SimulateOptions {
  SceneChoice scene;
  std::optional<double> omega;  ///< [rad/s], in place of the scene's
  std::string fidelity;         ///< in place of the scene's; empty for that
  double width = 0.25;          ///< smoothing width of the surrogate shown
  bool json = false;
  std::string csv;   ///< file for the path, empty for none
  std::string plot;  ///< SVG file for the path, empty for none
};

/// One run: impacts, peaks, count, certainty. Returns the exit code.
int simulate(const SimulateOptions& options);

}  // namespace ricochet::cli
