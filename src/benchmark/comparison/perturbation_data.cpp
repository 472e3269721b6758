#include "src/benchmark/comparison/perturbation_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "src/benchmark/comparison/atlas_data.h"
#include "src/benchmark/statistics/fisher_exact_test.h"
#include "src/benchmark/statistics/holm.h"
#include "src/benchmark/statistics/mean_share.h"
#include "src/benchmark/statistics/signed_rank_test.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

constexpr double level = 0.05;  // significance level of the tests

/// The runs of one entry on the problems of a family under one perturbation.
struct Tally {
  int solved = 0, runs = 0;

  double share() const { return solved / static_cast<double>(runs); }
};

using ByPerturbation = std::map<std::string, Tally>;

/// The problems of a family that are run under perturbations.
struct Tried {
  std::set<std::size_t> problems = {};
  Eigen::Index least_variables = 0, most_variables = 0;
  std::int64_t budget = 0;  ///< the largest, in evaluations for each variable

  void add(std::size_t problem, Eigen::Index variables, std::int64_t evaluations) {
    budget = std::max(budget, evaluations);
    least_variables = problems.empty() ? variables : std::min(least_variables, variables);
    most_variables = std::max(most_variables, variables);
    problems.insert(problem);
  }
};

/// Family and solver, then formulation.
using Table = std::map<std::pair<std::string, std::string>, std::map<std::string, ByPerturbation>>;

/// Returns the formulation in which a solver does best over all perturbations together. The
/// unperturbed runs alone would be biased: a formulation that was lucky there would seem to be
/// harmed by every perturbation.
const std::pair<const std::string, ByPerturbation>& best_formulation(
    const std::map<std::string, ByPerturbation>& formulations) {
  const auto mean = [](const ByPerturbation& tallies) {
    double sum = 0;
    for (const auto& [perturbation, tally] : tallies) sum += tally.share();
    return sum / static_cast<double>(tallies.size());
  };
  return *std::max_element(
      formulations.begin(), formulations.end(),
      [&](const auto& a, const auto& b) { return mean(a.second) < mean(b.second); });
}

/// Returns the results under a perturbation and those of the same cells without it, so that the two
/// differ in the perturbation alone.
std::vector<CellResult> disturbed(const std::vector<CellResult>& all) {
  const auto place = [](const Cell& cell) {
    return std::tie(cell.problem, cell.formulation, cell.solver, cell.budget);
  };
  std::set<std::tuple<std::string, std::string, std::string, std::int64_t>> tried;
  for (const CellResult& s : all) {
    const bool is_perturbation =
        s.cell->perturbation != nullptr && s.cell->cell.perturbation != "plain";
    if (is_perturbation) tried.insert(place(s.cell->cell));
  }
  std::vector<CellResult> results;
  for (const CellResult& s : all) {
    const bool counts = s.cell->perturbation != nullptr && s.cell->cell.gradient_price == "n";
    if (counts && tried.contains(place(s.cell->cell))) {
      results.push_back(s);
    }
  }
  return results;
}

/// An entry without and with the perturbation.
struct Change {
  std::string solver, family;
  Tally before, after;
  double p = 1;  ///< Fisher's exact test, with Holm's correction over all entries

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

/// Returns those that do significantly worse, the most harmed first.
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

Json summary_of(const Perturbation& perturbation, std::vector<Change>& changes) {
  std::vector<double> differences;
  for (const Change& change : changes) differences.push_back(change.difference());
  Json harmed = surely_harmed(changes);
  const auto sturdy = std::max_element(
      changes.begin(), changes.end(),
      [](const Change& a, const Change& b) { return a.after.share() < b.after.share(); });
  return {{"perturbation", perturbation.name},
          {"summary", perturbation.summary},
          {"entries", changes.size()},
          {"before", mean_json(changes, &Change::before)},
          {"after", mean_json(changes, &Change::after)},
          {"p", signed_rank_test(differences)},
          {"harmed_count", harmed.size()},
          {"harmed", harmed.empty() ? Json() : harmed.front()},
          {"sturdy", change_json(*sturdy)}};
}

/// With many perturbations some would seem significant by chance: Holm's correction.
void adjust(Json& summaries) {
  std::vector<double> p_values;
  for (const Json& row : summaries) p_values.push_back(row["p"]);
  const std::vector<double> adjusted = holm(p_values);
  for (std::size_t i = 0; i < adjusted.size(); ++i) {
    summaries[i]["p"] = adjusted[i];
    summaries[i]["sure"] = adjusted[i] < level;
  }
}

/// Returns true if some of these success rates is not 0.
bool solves(const Json& shares) {
  return std::ranges::any_of(
      shares, [](const Json& share) { return !share.is_null() && share.get<double>() > 0; });
}

}  // namespace

Json perturbation_data(const Campaign& campaign, const std::vector<CellResult>& all) {
  const std::vector<CellResult> results = disturbed(all);
  const auto largest = largest_budgets(results);
  std::set<std::string> there;
  Table table;
  std::map<std::string, Tried> tried;
  for (const CellResult& s : results) {
    const Cell& cell = s.cell->cell;
    there.insert(cell.perturbation);
    if (cell.budget != largest.at(s.cell->problem)) continue;
    const std::string& family = campaign.family_of(s.cell->problem);
    tried[family].add(s.cell->problem, campaign.problems()[s.cell->problem].dimension(),
                      cell.budget);
    Tally& tally = table[{family, cell.solver}][cell.formulation][cell.perturbation];
    for (const Outcome& outcome : s.outcomes) tally.solved += outcome.solved() ? 1 : 0;
    tally.runs += static_cast<int>(s.outcomes.size());
  }
  Json names = Json::array();
  Json summaries = Json::array();
  Json rows = Json::array();
  std::map<std::string, std::vector<Change>> changes;
  std::vector<const Perturbation*> perturbations;
  for (const Perturbation& perturbation : all_perturbations()) {
    if (!there.contains(perturbation.name)) continue;
    perturbations.push_back(&perturbation);
    names.push_back({{"perturbation", perturbation.name}});
  }
  for (const auto& [key, formulations] : table) {
    const auto& [formulation, tallies] = best_formulation(formulations);
    const auto plain = tallies.find("plain");
    Json cells = Json::array();
    for (const Perturbation* perturbation : perturbations) {
      const auto mine = tallies.find(perturbation->name);
      cells.push_back(mine == tallies.end() ? Json() : Json(mine->second.share()));
      if (mine == tallies.end() || plain == tallies.end() || mine == plain) continue;
      changes[perturbation->name].push_back({key.second, key.first, plain->second, mine->second});
    }
    const Tried& family = tried.at(key.first);
    rows.push_back(
        {{"entry", fmt::format("{}: {}, {}", key.first, key.second, formulation)},
         {"solves", solves(cells)},
         {"shares", std::move(cells)},
         {"family", key.first},
         {"solver", key.second},
         {"formulation", formulation},
         {"problems", family.problems.size()},
         {"least_variables", family.least_variables},
         {"most_variables", family.most_variables},
         {"budget", family.budget},
         {"runs", plain == tallies.end() ? tallies.begin()->second.runs : plain->second.runs}});
  }
  for (const Perturbation* perturbation : perturbations) {
    const auto found = changes.find(perturbation->name);
    if (found != changes.end()) summaries.push_back(summary_of(*perturbation, found->second));
  }
  adjust(summaries);
  Json data = {{"perturbations", std::move(summaries)},
               {"perturbation_names", std::move(names)},
               {"perturbation_rows", std::move(rows)}};
  data.update(atlas_data(campaign, results));
  return data;
}

}  // namespace ricochet::studies::comparison
