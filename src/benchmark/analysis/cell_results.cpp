#include "src/benchmark/analysis/cell_results.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "ricochet/error.h"
#include "src/benchmark/analysis/judged_runs.h"

namespace ricochet::comparison {

std::vector<CellResult> cell_results(const Campaign& campaign, const Store& store,
                                     const std::function<void(const StoredRun&)>& also) {
  const std::vector<Problem>& problems = campaign.problems();
  std::vector<std::shared_ptr<const Targets>> targets(problems.size());
  tbb::parallel_for(std::size_t{0}, problems.size(), [&](std::size_t q) {
    targets[q] = std::make_shared<const Targets>(targets_of(problems[q]));
  });
  std::vector<CellResult> all;
  for (const PlannedCell& cell : campaign.cells()) {
    all.push_back({&cell, {}, targets[cell.problem]});
  }
  std::int64_t there = 0;
  each_judged(
      store, [&](const JudgedRun& run) { also(run.stored); },
      [&](const JudgedCell& judged) {
        const PlannedCell* cell = campaign.find(judged.cell);
        if (cell == nullptr) return;
        all[static_cast<std::size_t>(cell - campaign.cells().data())].outcomes = judged.outcomes;
        there += static_cast<std::int64_t>(judged.outcomes.size());
      });
  if (there != campaign.runs()) {
    throw InputError(fmt::format("{} of {} runs are there: the campaign is not at its end", there,
                                 campaign.runs()));
  }
  return all;
}

std::map<std::size_t, std::int64_t> largest_budgets(const std::vector<CellResult>& results) {
  std::map<std::size_t, std::int64_t> largest;
  for (const CellResult& result : results) {
    auto& budget = largest[result.cell->problem];
    budget = std::max(budget, result.cell->cell.budget);
  }
  return largest;
}

}  // namespace ricochet::comparison
