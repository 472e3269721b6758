#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/studies/contest/study.h"

namespace ricochet::cli {

struct RunOptions {
  std::string plan = "default";          ///< TOML file, or the name of one that comes along
  std::string out = "reports/campaign";  ///< folder of its store, runs.sqlite
  std::string shard = "1/1";
  bool resume = false;
  int jobs = 0;       ///< runs at once; 0: one on every core, and under MPI one
  std::string serve;  ///< under MPI, what this process does: "store" or "runs"; see service.h
};

/// Carries out a plan, or goes on with it, as one of the ranks where mpirun has started several; a
/// whole campaign ends with its report.
int run_plan(const RunOptions& options);

/// What solvers do on questions, as a campaign of its own, which goes on by itself where it was
/// interrupted.
int compare(const studies::ContestOptions& options, bool quick, const std::string& out);

}  // namespace ricochet::cli
