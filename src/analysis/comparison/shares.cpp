#include "src/analysis/comparison/shares.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/order.h"
#include "src/analysis/rating.h"
#include "src/analysis/results.h"
#include "src/analysis/statistics/intervals.h"
#include "src/core/instance.h"

namespace ricochet::studies::comparison {

namespace {

using report::Json;

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

/// Returns a map of machines over perturbations for the share solved, and one for each kind of
/// failure.
Json maps_of(const Fates& fates, const std::map<std::string, std::string>& names) {
  std::vector<std::string> perturbations;
  for (const Perturbation& perturbation : all_perturbations()) {
    const bool there = std::any_of(fates.begin(), fates.end(), [&](const auto& fate) {
      return fate.first.second == perturbation.name;
    });
    if (there) perturbations.push_back(perturbation.name);
  }
  std::vector<std::string> kinds = {"solved"};
  for (const auto& [key, fate] : fates) {
    for (const auto& [kind, times] : fate.kinds) {
      if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
    }
  }
  Json maps = Json::array();
  for (const std::string& kind : kinds) {
    Json rows = Json::array();
    double most = 0;
    for (const auto& [machine, name] : names) {
      Json cells = Json::array();
      for (const std::string& perturbation : perturbations) {
        const auto fate = fates.find({machine, perturbation});
        if (fate == fates.end()) {
          cells.push_back(nullptr);
          continue;
        }
        const auto times = fate->second.kinds.find(kind);
        const int ended = kind == "solved"                    ? fate->second.solved
                          : times == fate->second.kinds.end() ? 0
                                                              : times->second;
        const double share = ended / static_cast<double>(fate->second.runs);
        most = std::max(most, share);
        cells.push_back(share);
      }
      rows.push_back({{"machine", name}, {"cells", std::move(cells)}});
    }
    maps.push_back(
        {{"number", maps.size() + 1}, {"kind", kind}, {"most", most}, {"rows", std::move(rows)}});
  }
  return maps;
}

}  // namespace

Json atlas_data(const Campaign& campaign, const std::vector<CellResult>& results) {
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
  Json rows = Json::array();
  std::map<std::string, std::string> names;
  for (const auto& [key, fate] : fates) {
    const std::string& machine = key.first;
    const std::string& perturbation = key.second;
    const auto factor = [&](const char* name) {
      const auto found = factors[machine].find(name);
      return found == factors[machine].end() ? Json() : Json(found->second);
    };
    names[machine] = name_of(machine, factors[machine]);
    Json row = {{"machine", machine},
                {"restitution", factor("restitution")},
                {"friction", factor("friction")},
                {"disturbance", factor("disturbance")},
                {"perturbation", perturbation},
                {"runs", fate.runs},
                {"share", fate.solved / static_cast<double>(fate.runs)},
                {"command", fate.command}};
    const Interval interval = wilson_interval(fate.solved, fate.runs);
    row["lower"] = interval.lower;
    row["upper"] = interval.upper;
    std::string kinds;
    for (const auto& [kind, times] : fate.kinds) {
      kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", times, kind);
    }
    row["kinds"] = kinds;
    rows.push_back(std::move(row));
  }
  return {{"atlas", std::move(rows)}, {"atlas_maps", maps_of(fates, names)}};
}

Json failure_data(const ricochet::comparison::Comparison& comparison) {
  Json rows = Json::array();
  for (const auto& result : comparison.results) {
    const Cell& cell = result.cell->cell;
    // The number of failures, and the first instance with one.
    std::map<std::string, std::pair<int, int>> failures;
    for (const auto& outcome : result.outcomes) {
      if (outcome.failure.empty()) continue;
      ++failures.try_emplace(outcome.failure, 0, outcome.instance).first->second.first;
    }
    for (const auto& [what, times] : failures) {
      rows.push_back({{"solver", cell.solver},
                      {"problem", cell.problem},
                      {"formulation", cell.formulation},
                      {"what", what},
                      {"times", times.first},
                      {"runs", result.outcomes.size()},
                      {"command", fmt::format("ricochet solve '{}' {} --formulation {} --budget {} "
                                              "--instance {} --seed {}",
                                              cell.solver, cell.problem, cell.formulation,
                                              result.cell->budget.evaluations, times.second,
                                              comparison.run)}});
    }
  }
  return rows;
}

namespace {

void add_ceilings(Json& rows, const Comparison& comparison, const Group& group) {
  for (const std::size_t q : group.problems) {
    const Problem& problem = comparison.campaign->problems()[q];
    for (const Formulation& formulation : problem.formulations(comparison.part->smoothings)) {
      if (formulation.smoothing == 0 || formulation.penalised) continue;
      const auto found = ceiling(problem, formulation.smoothing);
      if (!found) continue;
      rows.push_back(
          {{"family", group.family},
           {"problem", problem.name},
           {"smoothing", formulation.smoothing},
           {"optimum", found->optimum},
           {"best", (*problem.best_point)[0]},
           {"distance", found->distance},
           {"optimality_gap", found->optimality_gap},
           {"solves", found->optimality_gap && *found->optimality_gap <= problem.tolerance}});
    }
  }
}

}  // namespace

Json formulation_data(const Comparison& comparison, const std::vector<Group>& groups) {
  Json rows = Json::array();
  for (const Group& group : groups) {
    for (const auto& [solver, formulations] : shares_by_formulation(comparison, group)) {
      if (formulations.size() < 2) continue;
      for (const auto& [formulation, share] : formulations) {
        Json row = {{"family", group.family},
                    {"solver", solver},
                    {"formulation", formulation},
                    {"runs", share.trials}};
        row.update(share_data(share));
        rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

Json ceiling_data(const Comparison& comparison, const std::vector<Group>& groups) {
  Json rows = Json::array();
  for (const Group& group : groups) add_ceilings(rows, comparison, group);
  return rows;
}

Json share_data(const Share& share) {
  const Interval interval = wilson_interval(share.successes, share.trials);
  return {{"share", share.successes / static_cast<double>(share.trials)},
          {"lower", interval.lower},
          {"upper", interval.upper}};
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

Json variables_of(const Campaign& campaign, const std::vector<std::size_t>& problems) {
  Eigen::Index least = campaign.problems()[problems.front()].dimension();
  Eigen::Index most = least;
  for (const std::size_t q : problems) {
    const Eigen::Index n = campaign.problems()[q].dimension();
    least = std::min(least, n);
    most = std::max(most, n);
  }
  return {
      {"variables", least == most ? std::to_string(least) : fmt::format("{} to {}", least, most)},
      {"several", most > 1}};
}

namespace {

/// The share of a problem's runs, over all entries, that did not solve it.
double difficulty_of(const Comparison& comparison, std::size_t problem) {
  Share solved{};
  for (const CellResult& result : comparison.results) {
    if (result.cell->problem == problem) add_runs(solved, result);
  }
  return 1 - static_cast<double>(solved.successes) / solved.trials;
}

Json family_row(const Comparison& comparison, const Group& group, std::size_t number) {
  std::vector<double> difficulties;
  for (const std::size_t problem : group.problems) {
    difficulties.push_back(difficulty_of(comparison, problem));
  }
  std::vector<std::size_t> drawn;
  Json problems = Json::array();
  for (const std::size_t k :
       stratified_sample(difficulties, number, seed_of("sample", group.family, 0, 0))) {
    drawn.push_back(group.problems[k]);
    problems.push_back({{"problem", comparison.campaign->problems()[group.problems[k]].name},
                        {"difficulty", difficulties[k]}});
  }
  const std::size_t budget = comparison.part->budgets.size() - 1;
  const std::vector<Rating> ratings = rate(comparison, group.problems, budget);
  const Order whole = order_of(ratings);
  const Rating* leader = leader_of(ratings);
  const Order sample = order_of(rate(comparison, drawn, budget));
  return {{"family", group.family},
          {"of", group.problems.size()},
          {"problems", std::move(problems)},
          {"agreement", agreement_of(whole, sample)},
          {"leader", whole.leader},
          {"returned", leader != nullptr ? Json(leader->returned) : Json()},
          {"best", leader != nullptr ? Json(leader->probability_of_being_best) : Json()},
          {"sample_leader", sample.leader}};
}

}  // namespace

Json sample_data(const Campaign& campaign, const std::vector<CellResult>& results, double share,
                 std::size_t least) {
  Json rows = Json::array();
  for (const ReportedPart& part : reported_parts(campaign)) {
    const Comparison comparison = comparison_of(campaign, results, part.usual);
    for (Group group : groups_of(comparison)) {
      const auto part_of_all = std::llround(share * static_cast<double>(group.problems.size()));
      group.family = part.families.at(group.family);
      rows.push_back(
          family_row(comparison, group, std::max(least, static_cast<std::size_t>(part_of_all))));
    }
  }
  return rows;
}

}  // namespace ricochet::studies::comparison
