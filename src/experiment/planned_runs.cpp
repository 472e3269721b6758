#include "src/experiment/planned_runs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "ricochet/run.h"
#include "src/core/instance.h"
#include "src/core/progress.h"
#include "src/experiment/campaign.h"
#include "src/experiment/perturbations.h"
#include "src/experiment/worker.h"

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
      "arguments; otherwise start again, and these runs are repeated",
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

namespace {

void add(FnvHash& hash, double number) {
  hash.add({reinterpret_cast<const char*>(&number), sizeof number});
}

void add(FnvHash& hash, const Vector& x) {
  for (const double coordinate : x) add(hash, coordinate);
  hash.add("\xFF");
}

void add_true_values(FnvHash& hash, const Problem& problem, const Vector& x) {
  try {
    const TrueValues true_values = true_values_at(problem, x);
    add(hash, true_values.objective);
    add(hash, true_values.violation);
  } catch (const std::exception& error) {
    hash.add(error.what());
  }
}

}  // namespace

std::string problem_hash(const Problem& problem) {
  FnvHash hash;
  hash.add(problem.name);
  for (const Formulation& formulation : problem.formulations()) {
    hash.add(problem.name_of(formulation));
  }
  for (const double number : {problem.tolerance, problem.penalty_weight, problem.smoothing}) {
    add(hash, number);
  }
  for (const int number : {0, 1}) {
    const Problem seen = instance(problem, number);
    for (const Vector* x : {&seen.lower, &seen.upper, &seen.start}) add(hash, *x);
    if (seen.best_point) add(hash, *seen.best_point);
  }
  add_true_values(hash, problem, problem.start);
  if (problem.best_known) add(hash, *problem.best_known);
  if (problem.best_point) add_true_values(hash, problem, *problem.best_point);
  return fmt::format("{:016x}", hash.value());
}

namespace {

/// The shards that make up what is missing, the fewest that do; "" if none do. `is_missing` is in
/// the order in which runs are dealt to shards.
std::string shards_of(const std::vector<bool>& is_missing) {
  constexpr std::size_t most_shards = 1000;
  for (std::size_t count = 2; count <= std::min(most_shards, is_missing.size() / 2); ++count) {
    bool fits = true;
    for (std::size_t k = count; k < is_missing.size() && fits; ++k) {
      fits = is_missing[k] == is_missing[k - count];
    }
    if (!fits) continue;
    std::vector<std::size_t> shards;
    for (std::size_t k = 0; k < count; ++k) {
      if (is_missing[k]) shards.push_back(k + 1);
    }
    return fmt::format("shard{} {} of {}", shards.size() == 1 ? "" : "s", fmt::join(shards, ", "),
                       count);
  }
  return "";
}

/// The first of them, and how many more there are.
template <class Names>
std::string listed(const Names& names) {
  constexpr std::size_t most = 5;
  const auto shown = std::min(names.size(), most);
  const std::vector first(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown));
  return fmt::format("{}{}", fmt::join(first, ", "),
                     names.size() > shown ? fmt::format(" and {} more", names.size() - shown) : "");
}

}  // namespace

Completeness completeness_of(const Campaign& campaign, const Store& store) {
  Completeness found;
  for (const StoredSolver& solver : store.description().solvers) {
    const bool known = std::ranges::find(campaign.solvers(), solver.name, &Solver::name) !=
                       campaign.solvers().end();
    if (!known) found.unknown_solvers.push_back(solver.name);
  }
  const std::vector<PlanPart>& parts = campaign.plan().parts;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    found.parts.push_back({parts[k].name.empty() ? fmt::format("part {}", k + 1) : parts[k].name});
  }
  const std::vector<PlannedPlace> planned = planned_places(campaign);
  const std::set<RunKey> keys = store.keys();
  std::vector<bool> is_missing;
  std::set<std::string> problems, solvers;
  std::set<int> instances;
  for (const PlannedPlace& place : planned) {
    const Cell& cell = place.cell->cell;
    const bool there = keys.contains({cell, place.instance, place.run});
    is_missing.push_back(!there);
    found.planned += 1;
    found.present += there ? 1 : 0;
    for (const std::size_t part : place.cell->parts) {
      found.parts[part].planned += 1;
      found.parts[part].present += there ? 1 : 0;
    }
    if (there) continue;
    problems.insert(cell.problem);
    solvers.insert(cell.solver);
    instances.insert(place.instance);
  }
  if (found.missing() > 0 && found.present > 0) found.missing_shards = shards_of(is_missing);
  const std::int64_t others = static_cast<std::int64_t>(keys.size()) - found.present;
  found.planned += others;
  found.present += others;
  found.missing_problems.assign(problems.begin(), problems.end());
  found.missing_solvers.assign(solvers.begin(), solvers.end());
  found.missing_instances.assign(instances.begin(), instances.end());
  return found;
}

std::string in_words(const Completeness& found) {
  std::string unknown;
  if (!found.unknown_solvers.empty()) {
    unknown = fmt::format("; further runs of {} may be missing: this build has no such solver",
                          listed(found.unknown_solvers));
  }
  if (found.missing() == 0) {
    return fmt::format("all {} planned runs are present{}", found.planned, unknown);
  }
  std::string parts;
  for (const Completeness::Part& part : found.parts) {
    if (part.present == part.planned || found.parts.size() == 1) continue;
    parts += fmt::format("; {} of {} of {}", part.present, part.planned, part.name);
  }
  return fmt::format(
      "{} of {} planned runs are present, {} {} missing: {}{}of {}; of {}; on {} {}{}{}",
      found.present, found.planned, found.missing(), found.missing() == 1 ? "is" : "are",
      found.missing_shards, found.missing_shards.empty() ? "" : "; ",
      listed(found.missing_problems), listed(found.missing_solvers),
      found.missing_instances.size() == 1 ? "instance" : "instances",
      listed(found.missing_instances), parts, unknown);
}

std::string as_sentence(const Completeness& completeness) {
  std::string sentence = in_words(completeness) + ".";
  if (sentence.starts_with("all")) sentence[0] = 'A';
  return sentence;
}

}  // namespace ricochet
