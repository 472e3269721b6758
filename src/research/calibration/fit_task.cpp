#include "src/research/calibration/fit_task.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <thread>

#include "src/core/progress.h"
#include "src/research/paper/loss.h"

namespace ricochet::studies::calibration {
namespace {

std::vector<Fit> known_or_searched(const FitTask& task, FitStore& store) {
  std::vector<Fit> fits;
  for (const AskedFit& asked : task.asked) {
    auto known = store.find(asked);
    if (!known) break;
    fits.push_back(std::move(*known));
  }
  if (fits.size() == task.asked.size()) return fits;
  fits = task.search();
  store.add(task.asked, fits);
  return fits;
}

}  // namespace

FitTask fit_task(const std::string& kind, const carrier_track::Parameterisation& parameterisation,
                 const Search& search, const std::string& left_out) {
  AskedFit asked{fmt::format("{} by {}, seed {}", kind, search.global.name, search.seed),
                 parameterisation, left_out, options_of(search), [](const Fit& found) {
                   return carrier_track::loss(found.interpretation, found.constants,
                                              found.left_out);
                 }};
  return {{std::move(asked)},
          [=] { return std::vector{fit(parameterisation, search, left_out)}; },
          static_cast<double>(search.evaluations)};
}

std::vector<std::vector<Fit>> searched(const std::string& what, const std::vector<FitTask>& tasks,
                                       FitStore& store) {
  std::vector<std::size_t> order(tasks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return tasks[i].work; });
  double work = 0;
  for (const FitTask& task : tasks) work += task.work;
  Progress progress(what, work);
  std::vector<std::vector<Fit>> fits(tasks.size());
  std::atomic<std::size_t> next = 0;
  tbb::parallel_for(0U, std::max(1U, std::thread::hardware_concurrency()), [&](unsigned) {
    for (std::size_t k = next++; k < order.size(); k = next++) {
      if (tbb::is_current_task_group_canceling()) return;  // another one has failed
      const FitTask& task = tasks[order[k]];
      fits[order[k]] = known_or_searched(task, store);
      progress.advance(task.work);
    }
  });
  return fits;
}

std::vector<Fit> fits_by(const std::string& what, const std::vector<FitTask>& tasks,
                         FitStore& store) {
  std::vector<Fit> ends;
  for (std::vector<Fit>& fits : searched(what, tasks, store)) {
    ends.push_back(std::move(fits.back()));
  }
  return ends;
}

Search with_evaluations(Search search, std::int64_t evaluations) {
  search.evaluations = evaluations;
  return search;
}

}  // namespace ricochet::studies::calibration
