#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "src/benchmark/experiment/campaign/worker.h"
#include "src/core/progress.h"

namespace ricochet {

/// Makes all runs in the given order in other processes, one on every core. Passes each record to
/// `done`, with the index of its job, as soon as its run has ended. Except for times, records do
/// not depend on how the runs were distributed. If a run ends its process, it is made once more in
/// a fresh one, unless it was the first there, so that leftovers of other runs cannot make it fail.
/// A run whose process was killed from outside is also made once more. Throws the exceptions of
/// `done`, OutputError if too few files may be open, and std::system_error if no process can be
/// started; then no process is left.
void run_all(const std::vector<Job>& jobs, const Limits& limits,
             const std::function<void(std::size_t, RunRecord)>& done);

/// Number of files, pipes and sockets that run_all opens with so many processes at a time.
int open_files_of_runs(std::size_t processes);

/// Number of processes that run_all has at a time, if there are enough jobs.
std::size_t processes_of_runs();

/// The records in the order of the jobs.
std::vector<RunRecord> run_all(const std::vector<Job>& jobs, Progress& progress);

}  // namespace ricochet
