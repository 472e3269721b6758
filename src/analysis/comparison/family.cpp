#include "src/analysis/comparison/family.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "embedded/families.h"
#include "src/analysis/comparison/profiles.h"
#include "src/analysis/comparison/sections.h"
#include "src/analysis/comparison/shares.h"
#include "src/analysis/comparison/solver_pages.h"
#include "src/report/markdown_page.h"
#include "src/report/painted.h"

namespace ricochet::studies::comparison {

namespace {

using report::Chart;
using report::Mark;
using report::Results;
using report::Sample;
using report::Series;

const toml::table& families() {
  static const toml::table all = toml::parse(embedded::families);
  return all;
}

/// The text of a family, or of the one that it is like; nothing if neither has it.
std::optional<std::string> text_of(const std::string& family, const std::string& key) {
  const toml::table* own = families()[family].as_table();
  if (own == nullptr) return {};
  if (auto text = (*own)[key].value<std::string>()) return text;
  const auto like = (*own)["like"].value<std::string>();
  return like ? text_of(*like, key) : std::nullopt;
}

/// Sets the texts that say what a family asks; those that it lacks, or that an earlier part of the
/// page has word for word, are missing.
void set_texts(Results& part, const std::string& family, const Problem& problem,
               const std::vector<report::Part>& earlier) {
  Results names;
  names.set("smoothing", problem.smoothing);
  for (const char* key : {"minimise", "when", "measure", "risk"})
    names.set(key, text_of(family, key));
  for (const char* key :
       {"asks", "formula", "constraints", "surrogate", "derivatives", "instances", "users"}) {
    const auto text = text_of(family, key);
    const Value filled = text ? value_of(report::filled_line(*text, names)) : Value();
    const bool told = std::ranges::any_of(
        earlier, [&](const report::Part& one) { return *one.results.value(key) == filled; });
    part.set(key, told ? Value() : filled);
  }
  part.set("title", report::filled_line(text_of(family, "title").value_or(family), names));
}

Table variable_table(const Problem& problem) {
  Table table{"variables",
              {{"variable"},
               {"unit"},
               {"lower", "lowest", ".6g", 17},
               {"upper", "highest", ".6g", 17},
               {"start", "", ".6g", 17}}};
  for (Eigen::Index i = 0; i < problem.dimension(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Variable variable =
        k < problem.variables.size() ? problem.variables[k] : Variable{fmt::format("x{}", i), ""};
    table.add(variable.name, variable.unit, problem.lower[i], problem.upper[i], problem.start[i]);
  }
  return table;
}

Table taken_formulations(const Problem& problem) {
  Table table{"taken-formulations",
              {{"formulation"}, {"constraints"}, {"derivatives"}, {"residuals"}}};
  for (const Formulation& formulation : problem.formulations()) {
    const Problem formulated = problem.formulated(formulation);
    table.add(problem.name_of(formulation), formulated.constraints,
              static_cast<bool>(formulated.differentiate), static_cast<bool>(formulated.residuals));
  }
  return table;
}

/// The curve of one formulation over the problem's one variable: steps for a count, a line for a
/// surrogate.
Series curve_of(const Problem& problem, const Formulation& formulation) {
  constexpr int samples = 720;
  constexpr double fineness = 2000;  // of the chart: half a pixel of a large screen
  const Problem formulated = problem.formulated(formulation);
  const double width = problem.upper[0] - problem.lower[0];
  Series curve{
      problem.name_of(formulation), formulation.smoothing > 0 ? Mark::line : Mark::steps, {}};
  double least = 0, most = 0;
  for (int k = 0; k <= samples; ++k) {
    const Vector x = Vector::Constant(1, problem.lower[0] + width * k / samples);
    const Values values = formulated.evaluate(x);
    const double value = formulated.constraints > 0 ? values.constraints[0] : values.objective;
    least = k == 0 ? value : std::min(least, value);
    most = k == 0 ? value : std::max(most, value);
    const bool level = curve.mark == Mark::steps && !curve.samples.empty() && k < samples &&
                       curve.samples.back().value == value;
    if (!level) curve.samples.push_back({x[0], value});
  }
  if (curve.mark == Mark::line && most > least) {
    curve.samples = report::simplified(curve.samples, width / fineness, (most - least) / fineness);
  }
  return curve;
}

/// A problem of one variable: its true values, and the surrogate if it has one.
Chart objective_chart(const Problem& problem) {
  const Variable variable =
      problem.variables.empty() ? Variable{"x", ""} : problem.variables.front();
  const std::string unit = variable.unit.empty() ? "" : " " + variable.unit;
  Chart chart{.name = "objective",
              .title = problem.name,
              .x = {variable.name + (unit.empty() ? "" : fmt::format(" [{}]", variable.unit)),
                    report::Scale::linear, report::Range{problem.lower[0], problem.upper[0]}},
              .y = {problem.constraints > 0 ? "constraint, quiet up to 0" : "objective"},
              .width = 780};
  chart.series.push_back(curve_of(problem, {}));
  if (problem.smoothed) chart.series.push_back(curve_of(problem, {problem.smoothing}));
  if (problem.constraints > 0) chart.lines.push_back({report::Direction::horizontal, 0, "limit"});
  if (problem.best_point) {
    const double best = (*problem.best_point)[0];
    chart.lines.push_back({report::Direction::vertical, best, "best known"});
    chart.title += fmt::format(": the best known {} is {:.4g}{}", variable.name, best, unit);
  }
  return chart;
}

/// Who is first with each budget, in sentences.
std::string first_sentences(const Table& leaders) {
  std::string text;
  each_row(leaders, [&](const Row& row) {
    text += fmt::format("{}With {} evaluations for each variable {} is first by mean rank",
                        text.empty() ? "" : " ", row.number("budget"), row.text("first"));
    if (const auto returned = row.number_if("returned")) {
      const auto best = row.number_if("best");
      text += fmt::format(": it solves {:.0f} % of its runs; {}", 100 * *returned,
                          best ? fmt::format("P(best) {:.2f} on {} of {} problems", *best,
                                             row.number("takes"), row.number("problems"))
                               : "one problem has no P(best)");
    }
    if (!is_missing(row["most"])) text += fmt::format("; {} solves most", row.text("most"));
    text += ".";
  });
  return text;
}

/// Adds what was measured of the entries with each budget.
void add_budgets(const RatedPart& rated, std::size_t g, Results& part) {
  const std::vector<std::int64_t>& budgets = rated.comparison.part->budgets;
  const Group& group = rated.groups[g];
  for (std::size_t b = budgets.size(); b-- > 0;) {  // the largest first
    const std::vector<Rating>& ratings = rated.ratings[g][b];
    report::Part budget{fmt::format("{}", budgets[b]), fmt::format("{}", budgets[b]), {}};
    budget.results.add(runtime_ecdf(group.family, budgets[b], ratings));
    budget.results.add(rating_table("ratings", ratings, group.problems.size()));
    part.add("budgets", std::move(budget));
  }
}

/// Adds what compares the entries, with the largest budget.
void add_set(const Campaign& campaign, const EntrySet& set, const Table& speed_accuracy,
             Results& part) {
  const Table rows = where(speed_accuracy, [&](const Row& row) {
    return row.text("family") == set.family && row.number_if("budget") == set.budget;
  });
  if (!where(rows, "complete", true).rows.empty()) {
    part.add(report::Chart(speed_accuracy_chart(rows, false)));
  }
  if (!set.compared()) return;
  if (!set.any_solved()) return;
  add_profiles(campaign, set, part);
  add_break_even(campaign, set, part);
}

/// Values that a page asks for and that a family without comparisons lacks.
void complete(Results& part) {
  for (const char* name : {"virtual-best", "here"})
    if (part.value(name) == nullptr) part.set(name, Value());
  for (const char* name : {"profile", "break-even"})
    if (part.table(name) == nullptr) part.add(Table{name});
}

}  // namespace

std::string page_of_family(const std::string& family) {
  return text_of(family, "page").value_or(family);
}

std::vector<FamilyPage> family_pages(const Campaign& campaign, const std::vector<RatedPart>& parts,
                                     const std::vector<EntrySet>& sets, const Table& leaders,
                                     const Table& speed_accuracy,
                                     const std::map<std::string, std::string>& hashes) {
  std::vector<FamilyPage> pages;
  for (const RatedPart& rated : parts) {
    for (std::size_t g = 0; g < rated.groups.size(); ++g) {
      const Group& group = rated.groups[g];
      const std::string own = campaign.family_of(group.problems.front());
      const std::string folder = page_of_family(own);
      auto page = std::ranges::find(pages, folder, &FamilyPage::folder);
      if (page == pages.end()) page = pages.insert(page, FamilyPage{folder, {}});
      report::Part part{group.family, group.family, {}};
      Results& results = part.results;
      const Problem& first = campaign.problems()[group.problems.front()];
      const Problem& constrained = campaign.problems()[*std::ranges::max_element(
          group.problems, {}, [&](std::size_t q) { return campaign.problems()[q].constraints; })];
      const std::vector<report::Part>& earlier = page->results.parts["families"];
      set_texts(results, own, first, earlier);
      if (page->results.values.empty()) {
        page->results.set("heading", text_of(folder, "title").value_or(folder));
      }
      results.set("family", group.family);
      results.set("finding", first_sentences(where(leaders, "family", group.family)));
      results.set("shown", first.name);
      results.set("penalty",
                  constrained.constraints > 0 ? value_of(constrained.penalty_weight) : Value());
      results.add(variable_table(first));
      results.add(taken_formulations(constrained));
      results.add(sorted(problem_table(rated, group, hashes), {"solving"}));
      if (first.dimension() == 1) results.add(objective_chart(first));
      add_budgets(rated, g, results);
      add_accuracy(rated, g, results);
      results.add(solved_map(rated, g));
      results.add(result_table(rated, group));
      results.add(formulation_table(rated.most(g)));
      results.add(ceiling_table(rated.comparison, group));
      for (const EntrySet& set : sets) {
        if (set.family == group.family && set.largest)
          add_set(campaign, set, speed_accuracy, results);
      }
      complete(results);
      page->results.add("families", std::move(part));
    }
  }
  return pages;
}

namespace {

constexpr double surely = 0.9, probably = 0.5;  // P(best)
constexpr double least_named = 0.1;             // success rate: less is no advice

/// P(best) of an entry that is worth naming; 0 of others.
double certainty_of(const Row& leader) {
  if (leader.number_if("returned").value_or(0) < least_named) return 0;
  return leader.number_if("best").value_or(0);
}

/// The families in which one solver is first.
struct FirstSolver {
  std::string solver;
  std::vector<std::string> families;
  double least = 1, most = 0;  ///< success rate
  double problems = 0;
};

/// The solvers that are first with a certainty in [from, below), and on what.
std::string firsts(const char* how, const Table& leaders, double from, double below) {
  std::vector<FirstSolver> solvers;
  each_row(leaders, [&](const Row& row) {
    if (certainty_of(row) < from || certainty_of(row) >= below) return;
    auto known = std::ranges::find(solvers, row.text("solver"), &FirstSolver::solver);
    if (known == solvers.end()) known = solvers.insert(known, FirstSolver{row.text("solver"), {}});
    known->families.push_back(row.text("family"));
    known->least = std::min(known->least, row.number("returned"));
    known->most = std::max(known->most, row.number("returned"));
    known->problems += row.number("takes");
  });
  std::vector<std::string> texts;
  for (const FirstSolver& one : solvers) {
    const std::string least = fmt::format("{:.0f}", 100 * one.least);
    const std::string most = fmt::format("{:.0f}", 100 * one.most);
    texts.push_back(fmt::format(
        "{} on {} (success rate {} %, {} problems)", one.solver, fmt::join(one.families, ", "),
        least == most ? most : fmt::format("{} to {}", least, most), one.problems));
  }
  return texts.empty() ? "" : fmt::format("{} {}. ", how, fmt::join(texts, "; "));
}

}  // namespace

std::string opening_of(const Table& all) {
  const Table leaders = where(all, "largest", true);
  const auto open =
      where(leaders, [](const Row& row) { return certainty_of(row) < probably; }).rows.size();
  std::string text =
      firsts(
          "First by mean rank, with a probability P(best) of 0.9 or more on problems like these:",
          leaders, surely, 2) +
      firsts("Less sure, P(best) of 0.5 to 0.9:", leaders, probably, surely);
  if (open > 0) {
    text += fmt::format(
        "On {} of {} kinds of problems no entry is named so: too few solve them, "
        "several are as good, or random search is enough.",
        open, leaders.rows.size());
  }
  while (text.ends_with(' ')) text.pop_back();
  return text;
}

}  // namespace ricochet::studies::comparison
