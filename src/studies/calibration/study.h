#pragma once

#include <filesystem>
#include <string>

#include "src/experiment/stored_campaign.h"
#include "src/report/site/study.h"

namespace ricochet::studies {

struct CalibrationOptions {
  std::string interpretation;  ///< empty: the default one
  bool all_interpretations = false;
  bool converge =
      false;  ///< searches the best interpretations at length, with several solvers and seeds
  int seed = 1;
  std::string solver = "pagmo-sade";  ///< global solver
  std::filesystem::path folder;       ///< the report's
};

/// Fits the unknown parameters to the paper's claims. The runs of its searches are stored in
/// runs.sqlite of the folder, and are not repeated. It writes interpretation.toml there, which
/// other commands can use. Its computation throws InputError for invalid options.
Study calibration_study(const CalibrationOptions& options, const Provenance& provenance);

}  // namespace ricochet::studies
