#pragma once

#include <filesystem>
#include <string>

#include "src/studies/study.h"

namespace ricochet::studies {

struct CalibrationOptions {
  std::string reading;  ///< empty: the default one
  bool all_readings = false;
  bool check = false;     ///< ranks the readings by another seed and by another solver too
  bool converge = false;  ///< searches the best readings at length, by several solvers and seeds
  int seed = 1;
  std::string solver = "pagmo-sade";  ///< that searches the whole of the bounds
  std::filesystem::path folder;       ///< the report's
};

/// Fits the open constants to the paper's claims. Goes on from the fits that fits.toml of the
/// folder holds, and writes reading.toml there, which other commands may compute with. Its
/// computation throws InputError for options that are none.
Study calibration_study(const CalibrationOptions& options);

}  // namespace ricochet::studies
