#include "src/benchmark/comparison/atlas_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "src/benchmark/statistics/wilson_interval.h"

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

}  // namespace ricochet::studies::comparison
