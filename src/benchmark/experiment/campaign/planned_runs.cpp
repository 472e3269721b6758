#include "src/benchmark/experiment/campaign/planned_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "ricochet/error.h"
#include "src/benchmark/experiment/campaign/relocated_optimum.h"
#include "src/benchmark/experiment/campaign/runner.h"
#include "src/benchmark/experiment/perturbations/perturbation.h"
#include "src/core/instance.h"
#include "src/core/interruption.h"
#include "src/core/progress.h"

namespace ricochet {
namespace {

/// Estimated length of one run.
double length_of(const Campaign& campaign, const PlannedCell& cell) {
  return campaign.problems()[cell.problem].cost * static_cast<double>(cell.budget.evaluations);
}

}  // namespace

std::vector<PlannedPlace> planned_places(const Campaign& campaign) {
  std::vector<PlannedPlace> places;
  for (const PlannedCell& cell : campaign.cells()) {
    const double length = length_of(campaign, cell);
    for (int k = 0; k < cell.instances; ++k) {
      const int instance = campaign.plan().first_instance + k;
      for (int run = 0; run < cell.seeds; ++run) places.push_back({&cell, instance, run, length});
    }
  }
  // The longest first, so that the last ones end at about the same time.
  std::ranges::stable_sort(places, std::ranges::greater(), &PlannedPlace::length);
  return places;
}

PlannedRuns::PlannedRuns(const Campaign& campaign, const Shard& shard,
                         const std::set<RunKey>& done) {
  const std::vector<PlannedPlace> places = planned_places(campaign);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i % static_cast<std::size_t>(shard.count) != static_cast<std::size_t>(shard.index - 1)) {
      continue;
    }
    const PlannedPlace& place = places[i];
    if (done.contains({place.cell->cell, place.instance, place.run})) continue;
    add(campaign, *place.cell, place.instance, place.run);
  }
}

PlannedRuns::PlannedRuns(const Campaign& campaign, const RunKey& key) {
  if (campaign.has(key)) add(campaign, *campaign.find(key.cell), key.instance, key.run);
}

void PlannedRuns::add(const Campaign& campaign, const PlannedCell& cell, int instance_number,
                      int run) {
  const auto place = place_named(cell.cell.perturbation);
  auto& problem = problems_[{cell.problem, cell.cell.formulation, place, instance_number}];
  if (!problem) {
    const Problem shown = campaign.problems()[cell.problem].formulated(cell.formulation);
    problem = std::make_unique<Problem>(place ? relocated(shown, *place, instance_number)
                                              : instance(shown, instance_number));
  }
  const Perturbation* perturbation =
      cell.cell.perturbation == "plain" ? nullptr : cell.perturbation;
  runs_.push_back({{cell.cell, instance_number, run},
                   {problem.get(), &campaign.solvers()[cell.solver], cell.budget, run,
                    shown_as(cell.cell.formulation, cell.cell.perturbation), perturbation},
                   length_of(campaign, cell)});
}

void require_unchanged(const Solver& solver) {
  const std::string file = solver.changed_file ? solver.changed_file() : "";
  if (file.empty()) return;
  throw InputError(fmt::format(
      "{}: changed while runs of {} were made; if {} itself writes it, it must not be among its "
      "arguments; otherwise start again, and these runs are made anew",
      file, solver.name, solver.name));
}

void make_runs(const Campaign& campaign, const Shard& shard, Store& store) {
  const PlannedRuns planned(campaign, shard, store.keys());
  std::vector<Job> jobs;
  double work = 0;
  for (const PlannedRun& run : planned.all()) {
    jobs.push_back(run.job);
    work += run.length;
  }
  Progress progress("running", std::max(work, 1.0));
  run_all(jobs, campaign.plan().limits, [&](std::size_t j, const RunRecord& record) {
    require_unchanged(*jobs[j].solver);
    store.add(planned.all()[j].key, record);
    progress.advance(planned.all()[j].length);
  });
  store.finish();
}

}  // namespace ricochet
