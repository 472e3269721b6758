#include "src/campaign/runner.h"

#include <tbb/parallel_for.h>

namespace ricochet {

std::vector<RunRecord> run_all(const std::vector<Job>& jobs, Progress& progress) {
  std::vector<RunRecord> records(jobs.size());
  tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) {
    records[i] = run(*jobs[i].problem, *jobs[i].solver, jobs[i].budget, jobs[i].number);
    progress.advance(1);
  });
  return records;
}

}  // namespace ricochet
