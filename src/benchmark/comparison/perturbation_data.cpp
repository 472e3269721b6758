#include "src/studies/contest/feature_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "src/statistics/fisher_exact_test.h"
#include "src/statistics/holm.h"
#include "src/statistics/mean_share.h"
#include "src/statistics/signed_rank_test.h"
#include "src/studies/contest/atlas_data.h"

namespace ricochet::studies::contest {
namespace {

using report::Json;

constexpr double level = 0.05;  // of the tests

/// The runs of one competitor on the questions of a family under one feature.
struct Tally {
  int solved = 0, runs = 0;

  double share() const { return solved / static_cast<double>(runs); }
};

using ByFeature = std::map<std::string, Tally>;

/// Family and solver, then form.
using Table = std::map<std::pair<std::string, std::string>, std::map<std::string, ByFeature>>;

/// The form in which a solver does best, under what features there are together: by the runs with
/// nothing disturbed alone, those that were lucky there would seem to be harmed by everything.
const std::pair<const std::string, ByFeature>& best_form(
    const std::map<std::string, ByFeature>& forms) {
  const auto mean = [](const ByFeature& tallies) {
    double sum = 0;
    for (const auto& [feature, tally] : tallies) sum += tally.share();
    return sum / static_cast<double>(tallies.size());
  };
  return *std::max_element(forms.begin(), forms.end(), [&](const auto& a, const auto& b) {
    return mean(a.second) < mean(b.second);
  });
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

/// A competitor before and after.
struct Change {
  std::string solver, family;
  Tally before, after;
  double p = 1;  ///< Fisher's, adjusted by Holm for all competitors under the feature

  double difference() const { return after.share() - before.share(); }
};

Json change_json(const Change& change) {
  return {{"solver", change.solver},         {"family", change.family},
          {"before", change.before.share()}, {"after", change.after.share()},
          {"runs", change.before.runs},      {"p", change.p}};
}

Json mean_json(const std::vector<Change>& changes, Tally Change::*when) {
  std::vector<double> shares;
  for (const Change& change : changes) shares.push_back((change.*when).share());
  const MeanShare mean = mean_share(shares);
  return {{"share", mean.mean}, {"lower", mean.interval.lower}, {"upper", mean.interval.upper}};
}

/// Those that are surely worse off, the most harmed first.
Json surely_harmed(std::vector<Change>& changes) {
  std::vector<double> p_values;
  for (const Change& c : changes) {
    p_values.push_back(
        fisher_exact_test({c.before.solved, c.before.runs}, {c.after.solved, c.after.runs}));
  }
  const std::vector<double> adjusted = holm(p_values);
  for (std::size_t i = 0; i < changes.size(); ++i) changes[i].p = adjusted[i];
  std::stable_sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) {
    return a.difference() < b.difference();
  });
  Json harmed = Json::array();
  for (const Change& c : changes) {
    if (c.p < level && c.difference() < 0) harmed.push_back(change_json(c));
  }
  return harmed;
}

Json summary_of(const Feature& feature, std::vector<Change>& changes) {
  std::vector<double> differences;
  for (const Change& change : changes) differences.push_back(change.difference());
  Json harmed = surely_harmed(changes);
  const auto sturdy = std::max_element(
      changes.begin(), changes.end(),
      [](const Change& a, const Change& b) { return a.after.share() < b.after.share(); });
  return {{"feature", feature.name},
          {"summary", feature.summary},
          {"competitors", changes.size()},
          {"before", mean_json(changes, &Change::before)},
          {"after", mean_json(changes, &Change::after)},
          {"p", signed_rank_test(differences)},
          {"harmed_count", harmed.size()},
          {"harmed", harmed.empty() ? Json() : harmed.front()},
          {"sturdy", change_json(*sturdy)}};
}

/// Of so many features some would seem to change something by chance: Holm's adjustment.
void adjust(Json& summaries) {
  std::vector<double> p_values;
  for (const Json& row : summaries) p_values.push_back(row["p"]);
  const std::vector<double> adjusted = holm(p_values);
  for (std::size_t i = 0; i < adjusted.size(); ++i) {
    summaries[i]["p"] = adjusted[i];
    summaries[i]["sure"] = adjusted[i] < level;
  }
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
    Tally& tally =
        table[{campaign.family_of(s.cell->question), cell.solver}][cell.form][cell.feature];
    for (const Outcome& outcome : s.outcomes) tally.solved += outcome.verdict.solved ? 1 : 0;
    tally.runs += static_cast<int>(s.outcomes.size());
  }
  Json names = Json::array();
  Json summaries = Json::array();
  Json rows = Json::array();
  std::map<std::string, std::vector<Change>> changes;
  std::vector<const Feature*> features;
  for (const Feature& feature : all_features()) {
    if (!there.contains(feature.name)) continue;
    features.push_back(&feature);
    names.push_back({{"feature", feature.name}});
  }
  for (const auto& [key, forms] : table) {
    const auto& [form, tallies] = best_form(forms);
    const auto plain = tallies.find("plain");
    Json cells = Json::array();
    for (const Feature* feature : features) {
      const auto mine = tallies.find(feature->name);
      cells.push_back(mine == tallies.end() ? Json() : Json(mine->second.share()));
      if (mine == tallies.end() || plain == tallies.end() || mine == plain) continue;
      changes[feature->name].push_back({key.second, key.first, plain->second, mine->second});
    }
    rows.push_back({{"competitor", fmt::format("{}: {}, {}", key.first, key.second, form)},
                    {"shares", std::move(cells)}});
  }
  for (const Feature* feature : features) {
    const auto found = changes.find(feature->name);
    if (found != changes.end()) summaries.push_back(summary_of(*feature, found->second));
  }
  adjust(summaries);
  Json data = {{"features", std::move(summaries)},
               {"feature_names", std::move(names)},
               {"feature_rows", std::move(rows)}};
  data.update(atlas_data(campaign, standings));
  return data;
}

}  // namespace ricochet::studies::contest
