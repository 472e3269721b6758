#include "src/benchmark/comparison/entry_changes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "src/benchmark/analysis/judged_runs.h"
#include "src/benchmark/comparison/profile_data.h"
#include "src/benchmark/statistics/holm.h"
#include "src/benchmark/statistics/signed_rank_test.h"

namespace ricochet::studies::comparison {
namespace {

using namespace ricochet::comparison;

using RunCosts = std::map<std::pair<int, int>, double>;  ///< by instance and run

std::map<Cell, RunCosts> costs_in(const Store& store) {
  std::map<Cell, RunCosts> all;
  each_judged(
      store,
      [&](const JudgedRun& run) {
        const RunKey& key = run.stored.key;
        const auto budget = static_cast<double>(key.cell.budget * run.problem.variables);
        all[key.cell][{key.instance, key.run}] = penalised_cost(run.outcome, budget);
      },
      [](const JudgedCell&) {});
  return all;
}

/// The logarithm of the ratio of the mean costs of the runs that both have; nothing if there are
/// none.
std::optional<double> log_ratio(const RunCosts& first, const RunCosts& second) {
  double of_first = 0;
  double of_second = 0;
  for (const auto& [run, cost] : first) {
    const auto other = second.find(run);
    if (other == second.end()) continue;
    of_first += cost;
    of_second += other->second;
  }
  if (of_first == 0) return std::nullopt;
  return std::log(of_second / of_first);
}

std::string version_in(const CampaignDescription& description, const std::string& solver) {
  const auto found = std::ranges::find(description.solvers, solver, &StoredSolver::name);
  return found == description.solvers.end() ? "" : found->version;
}

EntryChange change_of(const Cell& entry, const std::vector<double>& log_ratios) {
  EntryChange change{
      entry.solver, entry.formulation, entry.perturbation, entry.gradient_price, "", ""};
  change.problems = static_cast<int>(log_ratios.size());
  double sum = 0;
  for (const double ratio : log_ratios) {
    sum += ratio;
    change.cheaper += ratio < 0 ? 1 : 0;
    change.dearer += ratio > 0 ? 1 : 0;
  }
  change.ratio = std::exp(sum / change.problems);
  change.p_value = signed_rank_test(log_ratios);
  return change;
}

}  // namespace

EntryChanges entry_changes(const Store& first, const Store& second) {
  EntryChanges changes;
  const auto hashes = first.description().hashes();
  const auto other_hashes = second.description().hashes();
  for (const auto& [problem, hash] : hashes) {
    const auto other = other_hashes.find(problem);
    if (other == other_hashes.end() || other->second == hash) continue;
    changes.other_problems.push_back(problem);
  }
  struct OnProblem {
    std::int64_t budget;
    double log_ratio;
  };
  std::map<Cell, std::map<std::string, OnProblem>> entries;  // by cell without problem and budget
  const auto others = costs_in(second);
  for (const auto& [cell, costs] : costs_in(first)) {
    const auto other = others.find(cell);
    if (other == others.end() || std::ranges::count(changes.other_problems, cell.problem) > 0) {
      continue;
    }
    const auto ratio = log_ratio(costs, other->second);
    if (!ratio) continue;
    Cell entry = cell;
    entry.problem.clear();
    entry.budget = 0;
    const auto [known, fresh] =
        entries[entry].try_emplace(cell.problem, OnProblem{cell.budget, *ratio});
    if (!fresh && cell.budget > known->second.budget) known->second = {cell.budget, *ratio};
  }
  std::vector<double> p_values;
  for (const auto& [entry, problems] : entries) {
    std::vector<double> log_ratios;
    for (const auto& [problem, on] : problems) log_ratios.push_back(on.log_ratio);
    EntryChange& change = changes.entries.emplace_back(change_of(entry, log_ratios));
    change.version = version_in(first.description(), entry.solver);
    change.other_version = version_in(second.description(), entry.solver);
    p_values.push_back(change.p_value);
  }
  const std::vector<double> adjusted = holm(p_values);
  for (std::size_t k = 0; k < adjusted.size(); ++k) changes.entries[k].p_value = adjusted[k];
  std::ranges::stable_sort(changes.entries, {}, &EntryChange::p_value);
  return changes;
}

}  // namespace ricochet::studies::comparison
