#pragma once

#include <optional>
#include <string>

#include "src/cli/scene_choice.h"

namespace ricochet::cli {

struct SimulateOptions {
  SceneChoice scene;
  std::optional<double> omega;  ///< [rad/s], replaces the scene's
  std::string fidelity;         ///< replaces the scene's; empty: the scene's
  double smoothing = 0.25;      ///< smoothing parameter of the surrogate that is printed
  bool json = false;
  std::string csv;   ///< file for the path; empty: none
  std::string plot;  ///< SVG file for the path; empty: none
};

/// Simulates one run and prints impacts, peaks, count and certainty. Returns the exit code.
int simulate(const SimulateOptions& options);

}  // namespace ricochet::cli
