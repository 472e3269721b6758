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

namespace ricochet::studies::comparison {

namespace {

constexpr double significance = 0.05;  // of the tests

/// Returns the results under a perturbation and those of the same cells without it, with the
/// largest budget, so that the two differ in the perturbation alone.
std::vector<const CellResult*> disturbed(const std::vector<CellResult>& all) {
  const auto place = [](const Cell& cell) {
    return std::tie(cell.problem, cell.formulation, cell.solver, cell.budget, cell.gradient_price);
  };
  std::set<std::tuple<std::string, std::string, std::string, std::int64_t, std::string>> tried;
  std::map<std::size_t, std::int64_t> largest;
  for (const CellResult& s : all) {
    const bool perturbed = s.cell->perturbation != nullptr && s.cell->cell.perturbation != "plain";
    if (perturbed) tried.insert(place(s.cell->cell));
  }
  std::vector<const CellResult*> results;
  for (const CellResult& s : all) {
    if (s.cell->perturbation == nullptr || !tried.contains(place(s.cell->cell))) continue;
    auto& budget = largest[s.cell->problem];
    budget = std::max(budget, s.cell->cell.budget);
    results.push_back(&s);
  }
  std::erase_if(results, [&](const CellResult* s) {
    return s->cell->cell.budget != largest.at(s->cell->problem);
  });
  return results;
}

/// The runs of each solver on a family under each perturbation: family, solver, formulation,
/// perturbation, solved, runs, share. The formulation is that in which it does best over all
/// perturbations together. The unperturbed runs alone would be biased: a formulation that was lucky
/// there would seem to be harmed by every perturbation.
Table tallies_of(const Campaign& campaign, const std::vector<const CellResult*>& results) {
  Table runs{"runs",
             {{"family"},
              {"solver"},
              {"formulation"},
              {"perturbation"},
              {"budget"},
              {"solved"},
              {"runs"}}};
  for (const CellResult* s : results) {
    const Cell& cell = s->cell->cell;
    Share share{};
    add_runs(share, *s);
    runs.add(campaign.family_of(s->cell->problem), cell.solver, cell.formulation, cell.perturbation,
             cell.budget, share.successes, share.trials);
  }
  const Table tallies =
      with(aggregated(sorted(std::move(runs), {"family", "solver", "formulation", "perturbation"}),
                      {"family", "solver", "formulation", "perturbation"},
                      {{{"budget"}, "budget", most_of},
                       {{"solved"}, "solved", sum_of},
                       {{"runs"}, "runs", sum_of}}),
           {"share"},
           [](const Row& row) { return value_of(row.number("solved") / row.number("runs")); });
  const Table best = sorted(
      aggregated(tallies, {"family", "solver", "formulation"}, {{{"mean"}, "share", mean_of}}),
      {"-mean"});
  return where(tallies, [&](const Row& row) {
    const auto first = best.find([&](const Row& other) {
      return other["family"] == row["family"] && other["solver"] == row["solver"];
    });
    return (*first)["formulation"] == row["formulation"];
  });
}

/// An entry without and with the perturbation.
struct PerturbedEntry {
  Row before, after;

  double difference() const { return after.number("share") - before.number("share"); }
  double p() const {
    const auto share = [](const Row& row) {
      return Share{static_cast<int>(row.number("solved")), static_cast<int>(row.number("runs"))};
    };
    return fisher_exact_test(share(before), share(after));
  }
};

/// Sorts them, the most harmed first, and returns those that do significantly worse.
std::vector<PerturbedEntry> surely_harmed(std::vector<PerturbedEntry>& entries) {
  std::ranges::stable_sort(entries, {}, &PerturbedEntry::difference);
  std::vector<double> p_values;
  for (const PerturbedEntry& one : entries) p_values.push_back(one.p());
  p_values = holm(p_values);
  std::vector<PerturbedEntry> harmed;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (p_values[i] < significance && entries[i].difference() < 0) harmed.push_back(entries[i]);
  }
  return harmed;
}

void add_summary(Table& table, const Perturbation& perturbation,
                 std::vector<PerturbedEntry> entries) {
  std::vector<double> differences;
  for (const PerturbedEntry& one : entries) differences.push_back(one.difference());
  const auto mean = [&](Row PerturbedEntry::*when) {
    double sum = 0;
    for (const PerturbedEntry& one : entries) sum += (one.*when).number("share");
    return sum / static_cast<double>(entries.size());
  };
  const double before = mean(&PerturbedEntry::before), after = mean(&PerturbedEntry::after);
  const std::vector<PerturbedEntry> harmed = surely_harmed(entries);
  const Row best = std::ranges::max_element(entries, {}, [](const PerturbedEntry& one) {
                     return one.after.number("share");
                   })->after;
  std::optional<std::string> most;
  if (!harmed.empty()) {
    const auto& [plain, perturbed] = harmed.front();
    most = fmt::format("{} on {}: {:.0f} to {:.0f} %", plain.text("solver"), plain.text("family"),
                       100 * plain.number("share"), 100 * perturbed.number("share"));
  }
  table.add(perturbation.name, perturbation.summary, entries.size(), before, after,
            signed_rank_test(differences), harmed.size(), most,
            fmt::format("{} on {}: {:.0f} % of {} runs", best.text("solver"), best.text("family"),
                        100 * best.number("share"), best.number("runs")));
}

/// The share solved [%] over perturbation and entry, for entries that solve a run under any.
report::Chart perturbation_map(const Table& rates, const std::vector<std::string>& columns) {
  report::Chart chart{.name = "perturbations",
                      .title = "Success rate under each perturbation",
                      .x = {"perturbation"},
                      .y = {""},
                      .heat_map = report::HeatMap{"solved [%]", {}, report::Range{0, 100}},
                      .width = 900};
  chart.x.categories = columns;
  for (const std::string& column : columns)
    chart.heat_map->column_links.push_back("&perturbation=" + column);
  for (std::size_t i = rates.rows.size(); i-- > 0;) {  // from the bottom
    const Row row = rates[i];
    std::vector<std::optional<double>> cells;
    double most = 0;
    for (const std::string& column : columns) {
      cells.push_back(row.number_if(column));
      if (cells.back()) most = std::max(most, *cells.back() *= 100);
    }
    if (most == 0) continue;
    const std::string name = row.text("solver") + ", " + row.text("formulation");
    chart.y.categories.push_back(row.text("family") + ": " + name);
    chart.heat_map->rows.push_back(std::move(cells));
    chart.heat_map->row_links.push_back(
        fmt::format("../view#family={}&formulation=all&budget={}&entry={}", row.text("family"),
                    row.number("budget"), name));
  }
  chart.height = 120 + 16 * static_cast<int>(chart.y.categories.size());
  return chart;
}

/// Success rates: a row for each entry, a column for each of these perturbations.
Table rates_of(const Table& tallies, const std::vector<std::string>& perturbations) {
  Table rates = aggregated(tallies, {"family", "solver", "formulation"},
                           {{{"budget"}, "budget", most_of}, {{"runs"}, "runs", most_of}});
  rates.name = "perturbation-rates";
  for (const std::string& perturbation : perturbations) {
    const Table under = where(tallies, "perturbation", perturbation);
    rates = with(std::move(rates), {perturbation, "", ".0%", 3}, [&](const Row& row) {
      const auto mine = under.find([&](const Row& other) {
        return other["family"] == row["family"] && other["solver"] == row["solver"];
      });
      return mine ? (*mine)["share"] : Value();
    });
  }
  return rates;
}

/// With many perturbations some would seem significant by chance: Holm's correction.
void adjust(Table& summaries) {
  std::vector<double> p_values;
  each_row(summaries, [&](const Row& row) { p_values.push_back(row.number("p")); });
  p_values = holm(p_values);
  for (std::size_t i = 0; i < p_values.size(); ++i) {
    summaries.rows[i][summaries.index_of("p")] = p_values[i];
  }
}

/// How the runs under each perturbation ended: a row for each, a column for each kind of end.
Table outcome_table(const std::vector<const CellResult*>& results,
                    const std::vector<std::string>& perturbations) {
  std::map<std::string, std::map<std::string, int>> times;
  std::map<std::string, int> runs;
  std::set<std::string> kinds;
  for (const CellResult* s : results) {
    for (const Outcome& outcome : s->outcomes) {
      const std::string kind = kind_of_end(outcome, s->cell->budget.evaluations);
      kinds.insert(kind);
      ++times[s->cell->cell.perturbation][kind];
      ++runs[s->cell->cell.perturbation];
    }
  }
  Table table{"outcomes", {{"perturbation"}, {"runs"}}};
  for (const std::string& kind : kinds) table.columns.push_back({kind, kind + " [%]", ".1%", 3});
  for (const std::string& perturbation : perturbations) {
    std::vector<Value> row = {perturbation, static_cast<std::int64_t>(runs[perturbation])};
    for (const std::string& kind : kinds)
      row.emplace_back(times[perturbation][kind] / static_cast<double>(runs[perturbation]));
    table.add_row(std::move(row));
  }
  return table;
}

}  // namespace

bool add_perturbations(const Campaign& campaign, const std::vector<CellResult>& all,
                       report::Results& page) {
  const std::vector<const CellResult*> results = disturbed(all);
  const Table tallies = tallies_of(campaign, results);
  Table summaries{"perturbations",
                  {{"perturbation"},
                   {"summary", "what it does"},
                   {"entries"},
                   {"before", "without it, mean [%]", ".0%", 3},
                   {"after", "with it, mean [%]", ".0%", 3},
                   {"p", "", ".2g", 3},
                   {"harmed", "significantly harmed"},
                   {"most", "harmed most"},
                   {"best", "solves most under it"}}};
  std::vector<std::string> names;
  for (const Perturbation& perturbation : all_perturbations()) {
    const Table under = where(tallies, "perturbation", perturbation.name);
    if (under.rows.empty()) continue;
    names.push_back(perturbation.name);
    if (perturbation.name == "plain") continue;
    std::vector<PerturbedEntry> entries;
    each_row(under, [&](const Row& row) {
      const auto plain = tallies.find([&](const Row& other) {
        return other.text("perturbation") == "plain" && other["family"] == row["family"] &&
               other["solver"] == row["solver"];
      });
      if (plain) entries.push_back({*plain, row});
    });
    if (!entries.empty()) add_summary(summaries, perturbation, std::move(entries));
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
  Table rates = rates_of(tallies, names);
  Table outcomes = outcome_table(results, names);
  double runs = 0;
  each_row(outcomes, [&](const Row& row) { runs += row.number("runs"); });
  page.set("perturbed-runs", static_cast<std::int64_t>(runs));
  page.add(perturbation_map(rates, names));
  page.add(std::move(rates));
  page.add(std::move(summaries));
  page.add(std::move(outcomes));
  return true;
}

}  // namespace ricochet::studies::comparison
