#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/benchmark/experiment/campaign/worker.h"

namespace ricochet::cli {

struct SolveOptions {
  std::string solver, problem;
  std::string scene_file;              ///< use this machine; empty: no machine of the user
  std::vector<std::string> settings;   ///< of --set
  std::string formulation;             ///< its name; empty: the first that the solver accepts
  std::string perturbation = "plain";  ///< disturbs what the solver sees
  std::int64_t budget = 1000;          ///< evaluations
  int instance = 0;                    ///< 0: the original problem
  int seed = 0;                        ///< number of the run
  std::string trace;                   ///< CSV file of the improvements
  std::string plot;                    ///< SVG file of the improvements
  bool json = false;
  Limits limits;
};

/// Runs one solver once and prints its progress and its score.
int solve(const SolveOptions& options);

}  // namespace ricochet::cli
