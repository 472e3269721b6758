#pragma once

#include <cstdint>
#include <string>

namespace ricochet::cli {

struct CalibrateOptions {
  std::string reading;  ///< empty: the default one
  bool all_readings = false;
  bool quick = false;
  bool check = false;
  int seed = 1;
  std::string solver = "pagmo-sade";
  std::string out = "reports/calibration";
};

/// Fits the open constants to the paper's claims, goes on from the fits that the folder holds, and
/// writes the report. Returns the exit code.
int calibrate(const CalibrateOptions& options);

}  // namespace ricochet::cli
