#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "src/analysis/comparison/sections.h"
#include "src/analysis/comparison/shares.h"
#include "src/analysis/statistics/hypothesis_tests.h"
#include "src/analysis/statistics/intervals.h"

namespace ricochet::studies::comparison {

namespace {

constexpr double significance = 0.05;  // of the tests

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

/// By family and solver, then formulation.
using Tallies =
    std::map<std::pair<std::string, std::string>, std::map<std::string, ByPerturbation>>;

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

MeanShare mean_of(const std::vector<PerturbedEntry>& entries, Tally PerturbedEntry::*when) {
  std::vector<double> shares;
  for (const PerturbedEntry& one : entries) shares.push_back((one.*when).share());
  return mean_share(shares);
}

/// Sorts them, the most harmed first, and returns those that do significantly worse.
std::vector<PerturbedEntry> surely_harmed(std::vector<PerturbedEntry>& entries) {
  std::vector<double> p_values;
  for (const PerturbedEntry& c : entries) {
    p_values.push_back(
        fisher_exact_test({c.before.solved, c.before.runs}, {c.after.solved, c.after.runs}));
  }
  const std::vector<double> adjusted = holm(p_values);
  for (std::size_t i = 0; i < entries.size(); ++i) entries[i].p = adjusted[i];
  std::ranges::stable_sort(entries, {}, &PerturbedEntry::difference);
  std::vector<PerturbedEntry> harmed;
  for (const PerturbedEntry& c : entries) {
    if (c.p < significance && c.difference() < 0) harmed.push_back(c);
  }
  return harmed;
}

std::string harm_in_words(const PerturbedEntry& one) {
  return fmt::format("{} on {}: {:.0f} to {:.0f} %", one.solver, one.family,
                     100 * one.before.share(), 100 * one.after.share());
}

Table empty_summaries() {
  return {"perturbations",
          {{"perturbation"},
           {"summary", "what it does"},
           {"entries"},
           {"before", "without it, mean [%]", ".0%", 3},
           {"after", "with it, mean [%]", ".0%", 3},
           {"p", "", ".2g", 3},
           {"harmed", "significantly harmed"},
           {"most", "harmed most"},
           {"best", "best under it"}}};
}

void add_summary(Table& table, const Perturbation& perturbation,
                 std::vector<PerturbedEntry>& entries) {
  std::vector<double> differences;
  for (const PerturbedEntry& one : entries) differences.push_back(one.difference());
  const std::vector<PerturbedEntry> harmed = surely_harmed(entries);
  const auto best = std::ranges::max_element(
      entries, {}, [](const PerturbedEntry& one) { return one.after.share(); });
  table.add(perturbation.name, perturbation.summary, entries.size(),
            mean_of(entries, &PerturbedEntry::before).mean,
            mean_of(entries, &PerturbedEntry::after).mean, signed_rank_test(differences),
            harmed.size(), harmed.empty() ? Value() : value_of(harm_in_words(harmed.front())),
            fmt::format("{} on {}: {:.0f} % of {} runs", best->solver, best->family,
                        100 * best->after.share(), best->after.runs));
}

/// With many perturbations some would seem significant by chance: Holm's correction.
void adjust(Table& summaries) {
  std::vector<double> p_values;
  each_row(summaries, [&](const Row& row) { p_values.push_back(row.number("p")); });
  const std::vector<double> adjusted = holm(p_values);
  for (std::size_t i = 0; i < adjusted.size(); ++i) {
    summaries.rows[i][summaries.index_of("p")] = adjusted[i];
  }
}

/// The share solved [%] over perturbation and entry, for entries that solve a run under any.
report::Chart perturbation_map(const Table& rows, const std::vector<const Perturbation*>& columns) {
  report::Chart chart{.name = "perturbations",
                      .x = {"perturbation"},
                      .y = {""},
                      .heat_map = report::HeatMap{"solved [%]", {}, report::Range{0, 100}},
                      .width = 900};
  for (const Perturbation* column : columns) {
    chart.x.categories.push_back(column->name);
    chart.heat_map->column_links.push_back("&perturbation=" + column->name);
  }
  for (std::size_t i = rows.rows.size(); i-- > 0;) {  // from the bottom
    const Row row = rows[i];
    std::vector<std::optional<double>> cells;
    double most = 0;
    for (const Perturbation* column : columns) {
      cells.push_back(row.number_if(column->name));
      if (cells.back()) most = std::max(most, *cells.back() *= 100);
    }
    if (most == 0) continue;
    chart.y.categories.push_back(
        fmt::format("{}: {}, {}", row.text("family"), row.text("solver"), row.text("formulation")));
    chart.heat_map->rows.push_back(std::move(cells));
    chart.heat_map->row_links.push_back(
        fmt::format("../view#family={}&formulation=all&budget={}&entry={}, {}", row.text("family"),
                    row.number("budget"), row.text("solver"), row.text("formulation")));
  }
  chart.height = 120 + 16 * static_cast<int>(chart.y.categories.size());
  return chart;
}

}  // namespace

bool add_perturbations(const Campaign& campaign, const std::vector<CellResult>& all,
                       report::Results& page) {
  const std::vector<CellResult> results = disturbed(all);
  if (results.empty()) return false;
  const auto largest = largest_budgets(results);
  std::set<std::string> there;
  Tallies tallies;
  std::map<std::string, Tried> tried;
  std::size_t runs = 0;
  for (const CellResult& s : results) {
    const Cell& cell = s.cell->cell;
    there.insert(cell.perturbation);
    if (cell.budget != largest.at(s.cell->problem)) continue;
    const std::string& family = campaign.family_of(s.cell->problem);
    tried[family].add(s.cell->problem, campaign.problems()[s.cell->problem].dimension(),
                      cell.budget);
    Tally& tally = tallies[{family, cell.solver}][cell.formulation][cell.perturbation];
    for (const Outcome& outcome : s.outcomes) tally.solved += outcome.solved() ? 1 : 0;
    tally.runs += static_cast<int>(s.outcomes.size());
    runs += s.outcomes.size();
  }
  Table rates{"perturbation-rates",
              {{"family"},
               {"solver"},
               {"formulation"},
               {"problems"},
               {"least_variables"},
               {"most_variables"},
               {"budget"},
               {"runs"}}};
  std::vector<const Perturbation*> perturbations;
  for (const Perturbation& perturbation : all_perturbations()) {
    if (!there.contains(perturbation.name)) continue;
    perturbations.push_back(&perturbation);
    rates.columns.push_back({perturbation.name, "", ".0%", 3});
  }
  std::map<std::string, std::vector<PerturbedEntry>> changes;
  for (const auto& [key, formulations] : tallies) {
    const auto& [formulation, by_perturbation] = best_formulation(formulations);
    const auto plain = by_perturbation.find("plain");
    const Tally& usual =
        plain == by_perturbation.end() ? by_perturbation.begin()->second : plain->second;
    const Tried& family = tried.at(key.first);
    std::vector<Value> row = {key.first, key.second, formulation};
    for (const auto number : {static_cast<std::int64_t>(family.problems.size()),
                              static_cast<std::int64_t>(family.least_variables),
                              static_cast<std::int64_t>(family.most_variables), family.budget,
                              static_cast<std::int64_t>(usual.runs)}) {
      row.emplace_back(number);
    }
    for (const Perturbation* perturbation : perturbations) {
      const auto mine = by_perturbation.find(perturbation->name);
      row.push_back(mine == by_perturbation.end() ? Value() : value_of(mine->second.share()));
      if (mine == by_perturbation.end() || plain == by_perturbation.end() || mine == plain)
        continue;
      changes[perturbation->name].push_back({key.second, key.first, plain->second, mine->second});
    }
    rates.add_row(std::move(row));
  }
  Table summaries = empty_summaries();
  for (const Perturbation* perturbation : perturbations) {
    const auto found = changes.find(perturbation->name);
    if (found != changes.end()) add_summary(summaries, *perturbation, found->second);
  }
  if (summaries.rows.empty()) return false;
  adjust(summaries);
  std::vector<std::string> harmed;
  each_row(summaries, [&](const Row& row) {
    if (!is_missing(row["most"]))
      harmed.push_back(fmt::format("{} {}", row.text("perturbation"), row.text("most")));
  });
  page.set("finding", harmed.empty()
                          ? "No perturbation harms an entry significantly."
                          : fmt::format("Entries that a perturbation harms most: {}; the "
                                        "others none significantly.",
                                        fmt::join(harmed, "; ")));
  report::Chart map = perturbation_map(rates, perturbations);
  map.title = harmed.empty() ? "No perturbation harms an entry significantly"
                             : "Success rate under each perturbation";
  page.set("perturbed-runs", runs);
  page.add(std::move(summaries));
  page.add(std::move(rates));
  page.add(std::move(map));
  add_atlas(campaign, results, page);
  return true;
}

}  // namespace ricochet::studies::comparison
