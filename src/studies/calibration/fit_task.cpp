#include "src/studies/calibration/fit_task.h"

#include <tbb/parallel_for.h>

#include "src/campaign/progress.h"

namespace ricochet::studies::calibration {

std::vector<Fit> done(const std::string& what, const std::vector<FitTask>& tasks, FitStore& store) {
  std::vector<Fit> fits(tasks.size());
  double work = 0;
  for (const FitTask& task : tasks) work += static_cast<double>(task.search.evaluations);
  Progress progress(what, work);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, tasks.size(), 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          const FitTask& task = tasks[i];
          const std::string key = key_of(task.kind, task.freedom, task.search, task.left_out);
          if (const auto known = store.find(key)) {
            fits[i] = *known;
          } else {
            fits[i] = task.make(task.freedom, task.search, task.left_out);
            store.add(key, fits[i]);
          }
          progress.advance(static_cast<double>(task.search.evaluations));
        }
      },
      tbb::simple_partitioner());
  return fits;
}

Search with_evaluations(Search search, std::int64_t evaluations) {
  search.evaluations = evaluations;
  return search;
}

}  // namespace ricochet::studies::calibration
