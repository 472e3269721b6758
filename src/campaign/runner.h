#pragma once

#include <vector>

#include "src/campaign/progress.h"
#include "src/core/run.h"

namespace ricochet {

/// One run to be made; problem and solver outlive it.
struct Job {
  const Problem* problem;
  const Solver* solver;
  Budget budget;
  int number = 0;
};

/// Makes all runs, on every core. The records come in the order of the jobs and do not depend on
/// how the runs were spread, but for the times in them.
std::vector<RunRecord> run_all(const std::vector<Job>& jobs, Progress& progress);

}  // namespace ricochet
