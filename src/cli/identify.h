#pragma once

#include <string>

#include "problems/carrier_track/identification/knock_file.h"
#include "src/identification/identified_machine.h"

namespace ricochet::cli {

struct IdentifyOptions {
  carrier_track::KnockFiles files;
  std::string scene_file;
  std::string solver = studies::identification::usual_solver;
  double fastest = 18;  ///< [rad/s], end of the range of speeds
  bool json = false;
  std::string out;   ///< machine file (TOML) with the fitted constants; empty: none
  std::string plot;  ///< SVG file of residuals; empty: none
};

/// Fits a machine to recorded knocks and prints its constants and safe speed with their intervals.
/// Returns the exit code.
int identify(const IdentifyOptions& options);

}  // namespace ricochet::cli
