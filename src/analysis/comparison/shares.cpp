#include "src/analysis/comparison/shares.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "src/analysis/comparison/group.h"
#include "src/analysis/rating.h"
#include "src/analysis/results.h"
#include "src/analysis/statistics/intervals.h"

namespace ricochet::studies::comparison {

namespace {

/// Returns the kind of failure of a run that did not solve its problem.
std::string kind_of_failure(const Outcome& outcome, std::int64_t budget) {
  if (!outcome.failure.empty()) {
    const bool ended = outcome.failure.starts_with("crashed") ||
                       outcome.failure.starts_with("killed") ||
                       outcome.failure.starts_with("ended the process");
    return ended ? "killed or crashed" : "threw";
  }
  if (outcome.verdict.solved) return "evaluated, not returned";
  if (!outcome.verdict.feasible) return "nothing feasible";
  return outcome.evaluations < budget ? "gave up early" : "budget spent";
}

/// The outcomes of all runs on one machine under one perturbation.
struct Fate {
  int runs = 0, solved = 0;
  std::map<std::string, int> kinds;
  std::string command;
};

std::string command_of(const PlannedCell& cell, const Outcome& outcome, int run) {
  return fmt::format(
      "ricochet solve '{}' {} --formulation {} --perturbation {} --budget {} --instance {} --seed "
      "{}",
      cell.cell.solver, cell.cell.problem, cell.cell.formulation, cell.cell.perturbation,
      cell.budget.evaluations, outcome.instance, run);
}

/// A machine and its factors: "C1: 0.5, 0.1, 0.05".
std::string name_of(const std::string& machine, const std::map<std::string, double>& factors) {
  std::string text;
  for (const char* name : {"restitution", "friction", "disturbance"}) {
    const auto found = factors.find(name);
    if (found == factors.end()) continue;
    text += fmt::format("{} {}", text.empty() ? ":" : ",", found->second);
  }
  return machine + text;
}

/// Machine and perturbation.
using Fates = std::map<std::pair<std::string, std::string>, Fate>;

/// The kinds of outcomes, "solved" first.
std::vector<std::string> kinds_in(const Fates& fates) {
  std::vector<std::string> kinds = {"solved"};
  for (const auto& [key, fate] : fates) {
    for (const auto& [kind, times] : fate.kinds) {
      if (std::ranges::find(kinds, kind) == kinds.end()) kinds.push_back(kind);
    }
  }
  return kinds;
}

/// The share of a machine's runs under a perturbation that ended so [%]; nothing without runs.
std::optional<double> ended(const Fates& fates, const std::string& machine,
                            const std::string& perturbation, const std::string& kind) {
  const auto fate = fates.find({machine, perturbation});
  if (fate == fates.end()) return {};
  const auto times = fate->second.kinds.find(kind);
  const int number = kind == "solved"                    ? fate->second.solved
                     : times == fate->second.kinds.end() ? 0
                                                         : times->second;
  return 100 * number / static_cast<double>(fate->second.runs);
}

/// Machines over perturbations, for one kind of outcome.
report::Part map_of(const Fates& fates, const std::map<std::string, std::string>& names,
                    const std::string& kind) {
  report::Chart chart{.name = "atlas",
                      .x = {"perturbation"},
                      .y = {""},
                      .heat_map = report::HeatMap{"runs [%]", {}, report::Range{0, 100}}};
  for (const Perturbation& perturbation : all_perturbations()) {
    const bool there = std::ranges::any_of(
        fates, [&](const auto& fate) { return fate.first.second == perturbation.name; });
    if (there) chart.x.categories.push_back(perturbation.name);
  }
  double most = 0;
  for (auto name = names.rbegin(); name != names.rend(); ++name) {  // from the bottom
    chart.y.categories.push_back(name->second);
    auto& row = chart.heat_map->rows.emplace_back();
    for (const std::string& perturbation : chart.x.categories) {
      row.push_back(ended(fates, name->first, perturbation, kind));
      most = std::max(most, row.back().value_or(0));
    }
  }
  chart.title =
      fmt::format("{}: at most {:.0f} % of the runs on a machine under a perturbation", kind, most);
  chart.width = 900;
  chart.height = 230 + 26 * static_cast<int>(names.size());
  chart.description = fmt::format(
      "Heat map of the share of runs with the outcome {}, over perturbation and machine.", kind);
  std::string id = kind;
  std::erase(id, ',');
  std::ranges::replace(id, ' ', '-');
  report::Part part{id, kind, {}};
  part.results.add(std::move(chart));
  return part;
}

}  // namespace

void add_atlas(const Campaign& campaign, const std::vector<CellResult>& results,
               report::Results& page) {
  const auto largest = largest_budgets(results);
  Fates fates;
  std::map<std::string, std::map<std::string, double>> factors;
  for (const CellResult& s : results) {
    const Problem& problem = campaign.problems()[s.cell->problem];
    if (problem.machine.empty() || s.cell->cell.budget != largest.at(s.cell->problem)) continue;
    factors[problem.machine] = problem.factors;
    Fate& fate = fates[{problem.machine, s.cell->cell.perturbation}];
    for (std::size_t i = 0; i < s.outcomes.size(); ++i) {
      const Outcome& outcome = s.outcomes[i];
      ++fate.runs;
      if (outcome.solved()) {
        ++fate.solved;
        continue;
      }
      const std::string kind = kind_of_failure(outcome, s.cell->budget.evaluations);
      // Prefer a command of the kind of failure that is most specific to the perturbation.
      if (fate.command.empty() || (kind != "budget spent" && !fate.kinds.contains(kind))) {
        fate.command =
            command_of(*s.cell, outcome, static_cast<int>(i) % std::max(1, s.cell->seeds));
      }
      ++fate.kinds[kind];
    }
  }
  Table table{"atlas",
              {{"machine"},
               {"perturbation"},
               {"share", "success rate [%]", ".0%", 3},
               {"lower", "", ".0%", 3},
               {"upper", "", ".0%", 3},
               {"runs"},
               {"kinds", "other outcomes"},
               {"command", "repeats a failed run"}}};
  std::map<std::string, std::string> names;
  for (const auto& [key, fate] : fates) {
    const auto& [machine, perturbation] = key;
    names[machine] = name_of(machine, factors[machine]);
    const Interval interval = wilson_interval(fate.solved, fate.runs);
    std::vector<std::string> kinds;
    for (const auto& [kind, times] : fate.kinds) kinds.push_back(fmt::format("{} {}", times, kind));
    table.add(names[machine], perturbation, fate.solved / static_cast<double>(fate.runs),
              interval.lower, interval.upper, fate.runs, fmt::format("{}", fmt::join(kinds, ", ")),
              fate.command);
  }
  page.add(std::move(table));
  if (fates.empty()) return;
  for (const std::string& kind : kinds_in(fates)) page.add("outcomes", map_of(fates, names, kind));
}

Table failure_table(const std::vector<RatedPart>& parts) {
  Table table{"failures",
              {{"solver"},
               {"problem"},
               {"formulation"},
               {"what", "what happened"},
               {"times", "failed"},
               {"runs"},
               {"command"}}};
  for (const RatedPart& part : parts) {
    for (const CellResult& result : part.comparison.results) {
      const Cell& cell = result.cell->cell;
      // The number of failures, and the first instance with one.
      std::map<std::string, std::pair<int, int>> failures;
      for (const Outcome& outcome : result.outcomes) {
        if (outcome.failure.empty()) continue;
        ++failures.try_emplace(outcome.failure, 0, outcome.instance).first->second.first;
      }
      for (const auto& [what, times] : failures) {
        table.add(cell.solver, cell.problem, cell.formulation, what, times.first,
                  result.outcomes.size(),
                  fmt::format("ricochet solve '{}' {} --formulation {} --budget {} --instance {} "
                              "--seed {}",
                              cell.solver, cell.problem, cell.formulation,
                              result.cell->budget.evaluations, times.second, part.comparison.run));
      }
    }
  }
  return table;
}

Table formulation_table(const Comparison& comparison, const Group& group) {
  Table table{"formulations",
              {{"solver"},
               {"formulation"},
               {"share", "success rate [%]", ".0%", 3},
               {"lower", "", ".0%", 3},
               {"upper", "", ".0%", 3},
               {"runs"}}};
  for (const auto& [solver, formulations] : shares_by_formulation(comparison, group)) {
    if (formulations.size() < 2) continue;
    for (const auto& [formulation, share] : formulations) {
      const Interval interval = wilson_interval(share.successes, share.trials);
      table.add(solver, formulation, share.successes / static_cast<double>(share.trials),
                interval.lower, interval.upper, share.trials);
    }
  }
  return table;
}

Table ceiling_table(const Comparison& comparison, const Group& group) {
  Table table{"surrogate-bias",
              {{"problem"},
               {"smoothing"},
               {"optimum", "surrogate's optimum", ".3f"},
               {"best", "best point", ".3f"},
               {"distance", "off by", ".3f"},
               {"optimality_gap", "optimality gap", ".3g"},
               {"solves", "solves it", "mark"}}};
  for (const std::size_t q : group.problems) {
    const Problem& problem = comparison.campaign->problems()[q];
    for (const Formulation& formulation : problem.formulations(comparison.part->smoothings)) {
      if (formulation.smoothing == 0 || formulation.penalised) continue;
      const auto found = ceiling(problem, formulation.smoothing);
      if (!found) continue;
      table.add(problem.name, formulation.smoothing, found->optimum, (*problem.best_point)[0],
                found->distance, found->optimality_gap,
                found->optimality_gap && *found->optimality_gap <= problem.tolerance);
    }
  }
  return table;
}

std::map<std::string, std::map<std::string, Share>> shares_by_formulation(
    const Comparison& comparison, const Group& group) {
  std::map<std::string, std::map<std::string, Share>> shares;
  for (const CellResult& result : comparison.results) {
    const Cell& cell = result.cell->cell;
    if (cell.budget != comparison.part->budgets.back() || !group.has(result)) continue;
    add_runs(shares[cell.solver][cell.formulation], result);
  }
  return shares;
}

void add_runs(Share& share, const CellResult& result) {
  for (const Outcome& outcome : result.outcomes) {
    ++share.trials;
    share.successes += outcome.solved() ? 1 : 0;
  }
}

std::string variables_of(const Campaign& campaign, const std::vector<std::size_t>& problems) {
  Eigen::Index least = campaign.problems()[problems.front()].dimension();
  Eigen::Index most = least;
  for (const std::size_t q : problems) {
    const Eigen::Index n = campaign.problems()[q].dimension();
    least = std::min(least, n);
    most = std::max(most, n);
  }
  return least == most ? fmt::format("{} variable{}", least, most > 1 ? "s" : "")
                       : fmt::format("{} to {} variables", least, most);
}

namespace {

constexpr double solving_share = 0.5;  // of the runs
constexpr double significant_split = 0.05;
constexpr std::size_t fewest = 3;  // entries with a property, and without

struct Solved {
  const Solver* solver;
  std::string formulation;
  double share;
};

struct Property {
  std::string name;
  std::function<bool(const Solved&)> holds;
};

std::vector<Property> properties_of(const std::vector<Solved>& entries) {
  std::vector<Property> properties = {
      {"gradients",
       [](const Solved& entry) {
         return entry.solver->capabilities.derivatives != Capabilities::Order::value;
       }},
      {"stochastic", [](const Solved& entry) { return entry.solver->stochastic; }}};
  std::set<std::string> formulations;
  for (const Solved& entry : entries) formulations.insert(entry.formulation);
  for (const std::string& formulation : formulations) {
    properties.push_back({"formulation " + formulation, [formulation](const Solved& entry) {
                            return entry.formulation == formulation;
                          }});
  }
  return properties;
}

double mean(const std::vector<double>& shares) {
  return std::accumulate(shares.begin(), shares.end(), 0.0) / static_cast<double>(shares.size());
}

struct Split {
  std::string name;
  std::vector<double> those, others;  ///< success rates with and without the property
};

std::vector<Split> splits_of(const std::vector<Solved>& entries) {
  std::vector<Split> splits;
  for (const Property& property : properties_of(entries)) {
    Split split{property.name, {}, {}};
    for (const Solved& entry : entries) {
      (property.holds(entry) ? split.those : split.others).push_back(entry.share);
    }
    if (std::min(split.those.size(), split.others.size()) >= fewest) splits.push_back(split);
  }
  return splits;
}

}  // namespace

Separation separation_of(const Comparison& comparison, std::size_t problem) {
  std::vector<Solved> entries;
  for (const CellResult& result : comparison.results) {
    const Cell& cell = result.cell->cell;
    if (result.cell->problem != problem || cell.budget != comparison.part->budgets.back()) continue;
    Share solved{};
    add_runs(solved, result);
    entries.push_back({&comparison.campaign->solvers()[result.cell->solver], cell.formulation,
                       static_cast<double>(solved.successes) / solved.trials});
  }
  Separation separation{entries.size(),
                        static_cast<std::size_t>(std::ranges::count_if(
                            entries, [](const Solved& one) { return one.share >= solving_share; })),
                        {}};
  const std::vector<Split> splits = splits_of(entries);
  std::vector<double> p_values;
  for (const Split& split : splits) {
    p_values.push_back(rank_sum_test(split.those, split.others).p_value);
  }
  p_values = holm(p_values);
  const auto least = std::ranges::min_element(p_values);
  if (least == p_values.end() || *least >= significant_split) return separation;
  const Split& split = splits[static_cast<std::size_t>(least - p_values.begin())];
  separation.by = fmt::format("{}: {:.0f} %, without: {:.0f} %", split.name,
                              100 * mean(split.those), 100 * mean(split.others));
  return separation;
}

}  // namespace ricochet::studies::comparison
