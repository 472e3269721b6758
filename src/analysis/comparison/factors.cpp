#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "src/analysis/comparison/sections.h"
#include "src/analysis/comparison/shares.h"
#include "src/analysis/statistics/factorial_effects.h"
#include "src/analysis/statistics/hypothesis_tests.h"
#include "src/analysis/statistics/intervals.h"

namespace ricochet::studies::comparison {

namespace {

using report::Json;

constexpr std::size_t shown_entries = 5;

std::size_t level_of(const std::vector<double>& levels, double value) {
  return static_cast<std::size_t>(std::find(levels.begin(), levels.end(), value) - levels.begin());
}

bool excludes_zero(double lower, double upper) {
  return lower > 0 || upper < 0;
}

struct Measure {
  const char* name;
  double MachineResult::*value;
};
constexpr Measure measures[] = {{"share solved", &MachineResult::solved},
                                {"log10 of evaluations", &MachineResult::cost},
                                {"targets reached", &MachineResult::accuracy}};

/// Adds the significant effects and the mean to `rows`, the number of effects that are not
/// significant to `unsure`, and all main effects on the share solved to `main`.
void add_effects(Json& rows, std::size_t& unsure, Json& main, const std::string& family,
                 const ByEntry::value_type& entry,
                 const std::map<std::string, std::vector<double>>& factors) {
  std::vector<std::string> names;
  std::vector<std::size_t> sizes;
  for (const auto& [name, levels] : factors) {
    names.push_back(name);
    sizes.push_back(levels.size());
  }
  std::map<std::string, std::size_t> units;
  for (const Measure& measure : measures) {
    std::vector<Response> responses;
    for (const MachineResult& result : entry.second) {
      Response response{{},
                        units.try_emplace(result.problem->machine, units.size()).first->second,
                        result.*measure.value};
      for (const auto& [name, levels] : factors) {
        response.levels.push_back(level_of(levels, result.problem->factors.at(name)));
      }
      responses.push_back(std::move(response));
    }
    std::vector<FactorialEffect> effects;
    try {
      effects = factorial_effects(responses, sizes);
    } catch (const std::invalid_argument&) {
      return;  // too few machines for an estimate
    }
    for (const FactorialEffect& effect : effects) {
      const bool sure = excludes_zero(effect.interval.lower, effect.interval.upper);
      if (measure.value == &MachineResult::solved && effect.factors.size() == 1) {
        main.push_back({{"effect", effect.effect},
                        {"lower", effect.interval.lower},
                        {"upper", effect.interval.upper}});
      }
      if (!sure && !effect.factors.empty()) {
        ++unsure;
        continue;
      }
      std::string of;
      for (std::size_t f = 0; f < effect.factors.size(); ++f) {
        const std::string& name = names[effect.factors[f]];
        of += fmt::format("{}{} {}", f == 0 ? "" : ", ", name,
                          level_name(name, factors.at(name)[effect.levels[f]]));
      }
      rows.push_back({{"family", family},
                      {"entry", name_of(entry)},
                      {"measure", measure.name},
                      {"of", of.empty() ? "mean" : of},
                      {"order", effect.factors.size()},
                      {"effect", effect.effect},
                      {"lower", effect.interval.lower},
                      {"upper", effect.interval.upper}});
    }
  }
}

/// The levels of all factors, in the order of their main effects.
Json levels_of(const std::map<std::string, std::vector<double>>& factors) {
  Json all = Json::array();
  for (const auto& [name, levels] : factors) {
    for (const double level : levels) {
      all.push_back({{"level", fmt::format("{} {}", name, level_name(name, level))}});
    }
  }
  return all;
}

/// The largest significant effect of a level on the success rate of an entry; null if none is.
Json strongest_of(const Json& entries, const Json& levels) {
  Json strongest;
  double largest = 0;
  for (const Json& entry : entries) {
    for (std::size_t k = 0; k < entry["effects"].size(); ++k) {
      const Json& one = entry["effects"][k];
      const bool sure = excludes_zero(one["lower"], one["upper"]);
      const double size = std::abs(one["effect"].get<double>());
      if (!sure || size <= largest) continue;
      largest = size;
      strongest = {
          {"entry", entry["entry"]}, {"level", levels.at(k)["level"]}, {"effect", one["effect"]}};
    }
  }
  return strongest;
}

void add_turns(Json& rows, const std::string& family, const ByEntry& entries,
               const std::map<std::string, std::vector<double>>& factors) {
  for (const auto& [name, levels] : factors) {
    for (const double level : levels) {
      ByEntry here;
      for (const auto& [entry, results] : entries) {
        for (const MachineResult& result : results) {
          if (result.problem->factors.at(name) == level) here[entry].push_back(result);
        }
      }
      const auto order = best_first(here);
      const auto overall = best_first(entries);
      // The entry that is best over all machines may not take those of this level.
      const auto again = here.find(overall.front()->first);
      rows.push_back(
          {{"family", family},
           {"factor", name},
           {"level", level},
           {"level_name", level_name(name, level)},
           {"leader", name_of(*order.front())},
           {"share", mean_solved(order.front()->second)},
           {"overall", name_of(*overall.front())},
           {"share_of_overall", again == here.end() ? Json() : Json(mean_solved(again->second))},
           {"same", order.front()->first == overall.front()->first}});
    }
  }
}

}  // namespace

Json factor_data(const Campaign& campaign, const std::vector<CellResult>& results,
                 const std::vector<ReportedPart>& parts) {
  Json effects = Json::array();
  Json turns = Json::array();
  Json main_effects = Json::array();
  std::size_t unsure = 0;
  for (const ReportedPart& part : parts) {
    for (const auto& [family, entries] : machine_results(campaign, results, part)) {
      const auto factors = factors_of(entries);
      if (factors.empty()) continue;
      const auto order = best_first(entries);
      Json shown = Json::array();
      for (std::size_t k = 0; k < std::min(shown_entries, order.size()); ++k) {
        Json main = Json::array();
        add_effects(effects, unsure, main, family, *order[k], factors);
        if (main.empty()) continue;
        shown.push_back({{"entry", name_of(*order[k])}, {"effects", std::move(main)}});
      }
      if (!shown.empty()) {
        Json levels = levels_of(factors);
        Json strongest = strongest_of(shown, levels);
        main_effects.push_back({{"family", family},
                                {"levels", std::move(levels)},
                                {"strongest", std::move(strongest)},
                                {"entries", std::move(shown)}});
      }
      add_turns(turns, family, entries, factors);
    }
  }
  return {{"effects", std::move(effects)},
          {"unsure_effects", unsure},
          {"main_effects", std::move(main_effects)},
          {"turns", std::move(turns)}};
}

namespace {

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
struct PerturbedEntry {
  std::string solver, family;
  Tally before, after;
  double p = 1;  ///< Fisher's exact test, with Holm's correction over all entries

  double difference() const { return after.share() - before.share(); }
};

Json change_json(const PerturbedEntry& change) {
  return {{"solver", change.solver},         {"family", change.family},
          {"before", change.before.share()}, {"after", change.after.share()},
          {"runs", change.before.runs},      {"p", change.p}};
}

Json mean_json(const std::vector<PerturbedEntry>& changes, Tally PerturbedEntry::*when) {
  std::vector<double> shares;
  for (const PerturbedEntry& change : changes) shares.push_back((change.*when).share());
  const MeanShare mean = mean_share(shares);
  return {{"share", mean.mean}, {"lower", mean.interval.lower}, {"upper", mean.interval.upper}};
}

/// Returns those that do significantly worse, the most harmed first.
Json surely_harmed(std::vector<PerturbedEntry>& changes) {
  std::vector<double> p_values;
  for (const PerturbedEntry& c : changes) {
    p_values.push_back(
        fisher_exact_test({c.before.solved, c.before.runs}, {c.after.solved, c.after.runs}));
  }
  const std::vector<double> adjusted = holm(p_values);
  for (std::size_t i = 0; i < changes.size(); ++i) changes[i].p = adjusted[i];
  std::stable_sort(changes.begin(), changes.end(),
                   [](const PerturbedEntry& a, const PerturbedEntry& b) {
                     return a.difference() < b.difference();
                   });
  Json harmed = Json::array();
  for (const PerturbedEntry& c : changes) {
    if (c.p < level && c.difference() < 0) harmed.push_back(change_json(c));
  }
  return harmed;
}

Json summary_of(const Perturbation& perturbation, std::vector<PerturbedEntry>& changes) {
  std::vector<double> differences;
  for (const PerturbedEntry& change : changes) differences.push_back(change.difference());
  Json harmed = surely_harmed(changes);
  const auto sturdy = std::max_element(changes.begin(), changes.end(),
                                       [](const PerturbedEntry& a, const PerturbedEntry& b) {
                                         return a.after.share() < b.after.share();
                                       });
  return {{"perturbation", perturbation.name},
          {"summary", perturbation.summary},
          {"entries", changes.size()},
          {"before", mean_json(changes, &PerturbedEntry::before)},
          {"after", mean_json(changes, &PerturbedEntry::after)},
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
  std::map<std::string, std::vector<PerturbedEntry>> changes;
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
