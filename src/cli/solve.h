#pragma once

#include <cstdint>
#include <string>

#include "src/campaign/worker.h"

namespace ricochet::cli {

struct SolveOptions {
  std::string solver, question;
  std::string form;               ///< its name; empty: the first that the solver accepts
  std::string feature = "plain";  ///< that disturbs what it is shown
  std::int64_t budget = 1000;     ///< evaluations
  int instance = 0;               ///< 0: the question as stated
  int seed = 0;                   ///< number of the run
  std::string trace;              ///< CSV file of the improvements
  std::string plot;               ///< SVG file of the same
  bool json = false;
  Limits limits;
};

/// One run of one solver, watched, judged and shown.
int solve(const SolveOptions& options);

}  // namespace ricochet::cli
