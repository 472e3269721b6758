#include "src/studies/contest/feature_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "src/statistics/mean_share.h"
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

/// The cells of one solver in one form under one feature: shares solved, question by question.
using Shares = std::vector<double>;
using ByFeature = std::map<std::string, Shares>;

double mean_of(const Shares& shares) {
  double sum = 0;
  for (const double share : shares) sum += share;
  return sum / static_cast<double>(shares.size());
}

/// Family and solver, then form, then feature.
using Table = std::map<std::pair<std::string, std::string>, std::map<std::string, ByFeature>>;

/// The form in which a solver does best when nothing is disturbed; null where it never ran so.
const std::pair<const std::string, ByFeature>* best_form(
    const std::map<std::string, ByFeature>& forms) {
  const std::pair<const std::string, ByFeature>* best = nullptr;
  for (const auto& form : forms) {
    const auto plain = form.second.find("plain");
    if (plain == form.second.end()) continue;
    if (best == nullptr || mean_of(plain->second) > mean_of(best->second.at("plain"))) {
      best = &form;
    }
  }
  return best;
}

Json share_json(const Shares& shares) {
  const MeanShare mean = mean_share(shares);
  return {{"share", mean.mean}, {"lower", mean.interval.lower}, {"upper", mean.interval.upper}};
}

struct Harm {
  std::string solver, family;
  double before, after;
};

Json harm_json(const Harm& harm) {
  return {{"solver", harm.solver},
          {"family", harm.family},
          {"before", harm.before},
          {"after", harm.after}};
}

/// What a feature was tried on, and the same with nothing disturbed, so that the two differ in the
/// feature alone.
std::vector<StoredStanding> disturbed(const std::vector<StoredStanding>& all) {
  const auto place = [](const Cell& cell) {
    return std::tie(cell.question, cell.form, cell.solver, cell.budget);
  };
  std::set<std::tuple<std::string, std::string, std::string, std::int64_t>> tried;
  for (const StoredStanding& s : all) {
    if (s.cell->cell.feature != "plain") tried.insert(place(s.cell->cell));
  }
  std::vector<StoredStanding> standings;
  for (const StoredStanding& s : all) {
    if (s.cell->cell.gradient_price == "n" && tried.contains(place(s.cell->cell))) {
      standings.push_back(s);
    }
  }
  return standings;
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

Json atlas_of(const Campaign& campaign, const std::vector<StoredStanding>& standings,
              const std::map<std::size_t, std::int64_t>& largest) {
  std::map<std::pair<std::string, std::string>, Fate> fates;
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
  for (const auto& [key, fate] : fates) {
    const std::string& machine = key.first;
    const std::string& feature = key.second;
    const auto factor = [&](const char* name) {
      const auto found = factors[machine].find(name);
      return found == factors[machine].end() ? Json() : Json(found->second);
    };
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
  return rows;
}

}  // namespace

Json feature_data(const Campaign& campaign, const std::vector<StoredStanding>& all) {
  const std::vector<StoredStanding> standings = disturbed(all);
  const auto largest = largest_budgets(standings);
  std::set<std::string> there;
  Table table;
  for (const StoredStanding& s : standings) {
    const Cell& cell = s.cell->cell;
    there.insert(cell.feature);
    if (cell.budget != largest.at(s.cell->question)) continue;
    double solved = 0;
    for (const Outcome& outcome : s.outcomes) solved += outcome.verdict.solved ? 1 : 0;
    table[{campaign.family_of(s.cell->question), cell.solver}][cell.form][cell.feature].push_back(
        solved / static_cast<double>(s.outcomes.size()));
  }
  if (there.size() < 2) {
    return {{"features", Json::array()}, {"feature_rows", Json::array()}, {"atlas", Json::array()}};
  }
  std::vector<const Feature*> features;
  for (const Feature& feature : all_features()) {
    if (there.contains(feature.name)) features.push_back(&feature);
  }
  Json rows = Json::array();
  std::map<std::string, std::vector<Harm>> harms;
  for (const auto& [key, forms] : table) {
    const auto* best = best_form(forms);
    if (best == nullptr) continue;
    const auto& [form, by_feature] = *best;
    const double before = mean_of(by_feature.at("plain"));
    Json cells = Json::array();
    for (const Feature* feature : features) {
      const auto mine = by_feature.find(feature->name);
      if (mine == by_feature.end()) {
        cells.push_back(nullptr);
        continue;
      }
      cells.push_back(mean_of(mine->second));
      harms[feature->name].push_back({key.second, key.first, before, mean_of(mine->second)});
    }
    rows.push_back({{"family", key.first},
                    {"solver", key.second},
                    {"form", form},
                    {"competitor", fmt::format("{}: {}, {}", key.first, key.second, form)},
                    {"plain", share_json(by_feature.at("plain"))},
                    {"shares", std::move(cells)}});
  }
  Json summary = Json::array();
  for (const Feature* feature : features) {
    auto& mine = harms[feature->name];
    if (mine.empty() || feature->name == "plain") continue;
    std::stable_sort(mine.begin(), mine.end(), [](const Harm& a, const Harm& b) {
      return a.after - a.before < b.after - b.before;
    });
    // Unharmed is no merit of those that solve nothing anyhow.
    const auto sturdy = std::max_element(
        mine.begin(), mine.end(), [](const Harm& a, const Harm& b) { return a.after < b.after; });
    Shares before;
    Shares after;
    for (const Harm& harm : mine) {
      before.push_back(harm.before);
      after.push_back(harm.after);
    }
    summary.push_back({{"feature", feature->name},
                       {"summary", feature->summary},
                       {"competitors", mine.size()},
                       {"before", share_json(before)},
                       {"after", share_json(after)},
                       {"harmed", harm_json(mine.front())},
                       {"sturdy", harm_json(*sturdy)}});
  }
  Json names = Json::array();
  for (const Feature* feature : features) names.push_back({{"feature", feature->name}});
  return {{"features", std::move(summary)},
          {"feature_names", std::move(names)},
          {"feature_rows", std::move(rows)},
          {"atlas", atlas_of(campaign, standings, largest)}};
}

}  // namespace ricochet::studies::contest
