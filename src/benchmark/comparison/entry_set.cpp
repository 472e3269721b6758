#include "src/benchmark/comparison/entry_set.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "src/benchmark/statistics/bootstrap.h"
#include "src/benchmark/statistics/shifted_geometric_mean.h"

namespace ricochet::studies::comparison {
namespace {

/// By problem.
using ByProblem = std::map<std::size_t, const CellResult*>;

/// Merit of one formulation of a solver; larger is better.
std::tuple<std::size_t, double, double> merit(const Campaign& campaign, const ByProblem& taken) {
  double share = 0;
  std::vector<double> evaluations;
  for (const auto& [problem, result] : taken) {
    const OnProblem one = on_problem(campaign, *result);
    share += one.share;
    evaluations.push_back(one.evaluations);
  }
  return {taken.size(), share, -mean_cost(evaluations)};
}

}  // namespace

bool EntrySet::any_solved() const {
  for (const Entry& entry : entries) {
    for (const CellResult* result : entry.results) {
      for (const Outcome& outcome : result->outcomes) {
        if (outcome.solved()) return true;
      }
    }
  }
  return false;
}

OnProblem on_problem(const Campaign& campaign, const CellResult& of_cell) {
  OnProblem result{0, 0, 0, 0};
  std::vector<double> optimality_gaps;
  for (const Outcome& outcome : of_cell.outcomes) {
    result.evaluations += static_cast<double>(evaluations_until_solved(outcome));
    result.seconds += seconds_until_solved(outcome);
    result.share += outcome.solved() ? 1 : 0;
    optimality_gaps.push_back(outcome.optimality_gap());
  }
  const auto runs = static_cast<double>(of_cell.outcomes.size());
  const auto& stated = campaign.problems()[of_cell.cell->problem];
  result.evaluations =
      std::max(result.evaluations / runs, 1.0) / static_cast<double>(stated.dimension());
  result.seconds /= runs;
  result.share /= runs;
  result.optimality_gap = quantile(std::move(optimality_gaps), 0.5);
  return result;
}

double mean_cost(const std::vector<double>& costs) {
  return shifted_geometric_mean(costs, 0, 1e-6);
}

std::vector<EntrySet> entry_sets_of(const Campaign& campaign,
                                    const std::vector<CellResult>& results,
                                    const std::vector<ReportedPart>& parts) {
  using Key = std::tuple<std::size_t, std::string, std::int64_t>;
  std::map<Key, std::map<std::string, std::map<std::string, ByProblem>>> all;
  for (const CellResult& result : results) {
    const PlannedCell& cell = *result.cell;
    const bool plain = cell.cell.perturbation == "plain" && cell.cell.gradient_price == "n";
    if (!plain || result.outcomes.empty()) continue;
    const Key key{cell.parts.front(), campaign.family_of(cell.problem), cell.cell.budget};
    all[key][cell.cell.solver][cell.cell.formulation][cell.problem] = &result;
  }
  const auto largest = largest_budgets(results);
  std::vector<EntrySet> sets;
  for (const auto& [key, solvers] : all) {
    EntrySet set{std::get<1>(key), std::get<0>(key), std::get<2>(key), true, {}, {}, {}};
    std::map<std::size_t, bool> asked;
    for (const auto& [solver, formulations] : solvers) {
      for (const auto& [formulation, taken] : formulations) {
        for (const auto& [problem, result] : taken) asked[problem] = true;
      }
    }
    for (const auto& [problem, yes] : asked) {
      set.problems.push_back(problem);
      set.largest = set.largest && largest.at(problem) == set.budget;
    }
    for (const auto& [solver, formulations] : solvers) {
      const auto best = std::max_element(
          formulations.begin(), formulations.end(), [&](const auto& a, const auto& b) {
            return merit(campaign, a.second) < merit(campaign, b.second);
          });
      Entry entry{solver, best->first, {}};
      for (const auto& [problem, result] : best->second) entry.results.push_back(result);
      const bool takes_all = entry.results.size() == set.problems.size();
      (takes_all ? set.entries : set.partial).push_back(std::move(entry));
    }
    const auto part = std::find_if(parts.begin(), parts.end(), [&](const ReportedPart& reported) {
      return reported.part == set.part;
    });
    // Parts with drawn machines only serve to check whether the ranking is robust.
    const bool is_drawn = campaign.plan().parts[set.part].drawn_machines > 0;
    if (part == parts.end() && is_drawn) continue;
    if (part != parts.end()) {
      if (part->asked_again.contains(set.family)) continue;
      set.family = part->families.at(set.family);
    }
    sets.push_back(std::move(set));
  }
  return sets;
}

bool is_joined(const Campaign& campaign, const EntrySet& set) {
  return set.largest && 2 * set.entries.size() >= campaign.solvers().size();
}

EntrySet joint_entry_set(const Campaign& campaign, const std::vector<EntrySet>& sets) {
  EntrySet joint{"all", 0, 0, true, {}, {}, {}};
  std::size_t joined = 0;
  std::map<std::string, Entry> entries;
  for (const EntrySet& set : sets) {
    if (!is_joined(campaign, set)) continue;
    ++joined;
    joint.problems.insert(joint.problems.end(), set.problems.begin(), set.problems.end());
    for (const Entry& entry : set.entries) {
      Entry& mine = entries[entry.solver];
      mine.solver = entry.solver;
      mine.formulation = "the best of each";
      mine.results.insert(mine.results.end(), entry.results.begin(), entry.results.end());
    }
  }
  if (joined < 2) return {};
  for (auto& [solver, entry] : entries) {
    if (entry.results.size() == joint.problems.size()) {
      joint.entries.push_back(std::move(entry));
    }
  }
  return joint;
}

}  // namespace ricochet::studies::comparison
