#include "src/studies/contest/atlas_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "src/statistics/wilson_interval.h"

namespace ricochet::studies::contest {
namespace {

using report::Json;

/// What became of a run that did not solve its question.
std::string kind_of_failure(const Outcome& outcome, std::int64_t budget) {
  if (!outcome.failure.empty()) {
    const bool ended = outcome.failure.starts_with("crashed") ||
                       outcome.failure.starts_with("killed") ||
                       outcome.failure.starts_with("ended the process");
    return ended ? "killed or crashed" : "threw";
  }
  if (!outcome.verdict.feasible) return "nothing feasible";
  return outcome.evaluations < budget ? "gave up early" : "budget spent";
}

/// What became of all runs on one machine under one feature.
struct Fate {
  int runs = 0, solved = 0;
  std::map<std::string, int> kinds;
  std::string command;
};

std::string command_of(const PlannedCell& cell, const Outcome& outcome, int run) {
  return fmt::format(
      "ricochet solve '{}' {} --form {} --feature {} --budget {} --instance {} --seed {}",
      cell.cell.solver, cell.cell.question, cell.cell.form, cell.cell.feature,
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

/// Machine and feature.
using Fates = std::map<std::pair<std::string, std::string>, Fate>;

/// A map of machines over features for the share solved, and one for each kind of failure.
Json maps_of(const Fates& fates, const std::map<std::string, std::string>& names) {
  std::vector<std::string> features;
  for (const Feature& feature : all_features()) {
    const bool there = std::any_of(fates.begin(), fates.end(), [&](const auto& fate) {
      return fate.first.second == feature.name;
    });
    if (there) features.push_back(feature.name);
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
      for (const std::string& feature : features) {
        const auto fate = fates.find({machine, feature});
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

Json atlas_data(const Campaign& campaign, const std::vector<StoredStanding>& standings) {
  const auto largest = largest_budgets(standings);
  Fates fates;
  std::map<std::string, std::map<std::string, double>> factors;
  for (const StoredStanding& s : standings) {
    const Question& question = campaign.questions()[s.cell->question];
    if (question.machine.empty() || s.cell->cell.budget != largest.at(s.cell->question)) continue;
    factors[question.machine] = question.factors;
    Fate& fate = fates[{question.machine, s.cell->cell.feature}];
    for (std::size_t i = 0; i < s.outcomes.size(); ++i) {
      const Outcome& outcome = s.outcomes[i];
      ++fate.runs;
      if (outcome.verdict.solved) {
        ++fate.solved;
        continue;
      }
      const std::string kind = kind_of_failure(outcome, s.cell->budget.evaluations);
      // The command is of the kind that says most of the feature.
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
    const std::string& feature = key.second;
    const auto factor = [&](const char* name) {
      const auto found = factors[machine].find(name);
      return found == factors[machine].end() ? Json() : Json(found->second);
    };
    names[machine] = name_of(machine, factors[machine]);
    Json row = {{"machine", machine},
                {"restitution", factor("restitution")},
                {"friction", factor("friction")},
                {"disturbance", factor("disturbance")},
                {"feature", feature},
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

}  // namespace ricochet::studies::contest
