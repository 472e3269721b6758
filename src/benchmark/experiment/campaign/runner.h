#pragma once

#include <functional>
#include <vector>

#include "src/campaign/progress.h"
#include "src/campaign/worker.h"

namespace ricochet {

/// Makes all runs, the first ones first, in other processes, one on every core. Hands a record to
/// `done`, with the index of its job, as soon as its run has ended; records do not depend on how
/// the runs were spread, but for the times in them. A run that ends its process is made once more
/// in a fresh one, unless it was the first there, so that no run pays for what others left behind;
/// and so is one whose process somebody else has killed.
/// Throws what `done` throws, and std::system_error where there can be no process; then none is
/// left.
void run_all(const std::vector<Job>& jobs, const Limits& limits,
             const std::function<void(std::size_t, RunRecord)>& done);

/// The records in the order of the jobs.
std::vector<RunRecord> run_all(const std::vector<Job>& jobs, Progress& progress);

}  // namespace ricochet
