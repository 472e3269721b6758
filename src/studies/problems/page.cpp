#include "src/studies/problems/page.h"

#include <fmt/format.h>

#include <algorithm>

#include "src/core/verdict.h"
#include "src/report/text.h"

namespace ricochet::studies::problems {
namespace {

using report::Alignment;
using report::Mark;

constexpr int chart_samples = 720;
constexpr Eigen::Index coordinates_shown = 5;

std::string yes_or_no(bool holds) {
  return holds ? "yes" : "no";
}

/// A number as people read it.
std::string text_of(double value) {
  return fmt::format("{:.6g}", value);
}

std::string text_of(const Vector& point) {
  std::string text;
  for (Eigen::Index i = 0; i < std::min(point.size(), coordinates_shown); ++i) {
    text += fmt::format("{}{:.4g}", i == 0 ? "" : ", ", point[i]);
  }
  return point.size() > coordinates_shown ? text + ", …" : text;
}

std::string text_of(const Truth& truth) {
  if (truth.violation > 0) {
    return fmt::format("{}, too much by {}", text_of(truth.objective), text_of(truth.violation));
  }
  return text_of(truth.objective);
}

report::Table table_of_families(const std::vector<Family>& families) {
  report::Table table{"All families.",
                      {{"family", Alignment::left},
                       {"asks for", Alignment::left},
                       {"problems"},
                       {"variables"},
                       {"constraints"},
                       {"derivatives", Alignment::left},
                       {"judged as", Alignment::left}},
                      {}};
  for (const Family& family : families) {
    if (family.problems.empty()) continue;
    const auto range_of = [&family](const auto& of) {
      Eigen::Index fewest = of(family.problems.front());
      Eigen::Index most = fewest;
      for (const Problem& problem : family.problems) {
        fewest = std::min(fewest, of(problem));
        most = std::max(most, of(problem));
      }
      return fewest == most ? fmt::format("{}", most) : fmt::format("{} to {}", fewest, most);
    };
    table.rows.push_back({{family.name},
                          {family.title},
                          {fmt::format("{}", family.problems.size())},
                          {range_of([](const Problem& problem) { return problem.dimension(); })},
                          {range_of([](const Problem& problem) { return problem.constraints; })},
                          {yes_or_no(static_cast<bool>(family.problems.front().differentiate))},
                          {family.judged_as == family.name ? "itself" : family.judged_as}});
  }
  return table;
}

report::Table table_of_variables(const Problem& problem) {
  report::Table table{fmt::format("The variables of {}, and where a solver starts.", problem.name),
                      {{"variable", Alignment::left},
                       {"unit", Alignment::left},
                       {"lowest"},
                       {"highest"},
                       {"start"}},
                      {}};
  for (Eigen::Index i = 0; i < problem.dimension(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool named = k < problem.variables.size();
    const std::string unit = named ? problem.variables[k].unit : "";
    table.rows.push_back({{named ? problem.variables[k].name : fmt::format("x{}", i)},
                          {unit.empty() ? "–" : unit},
                          {text_of(problem.lower[i])},
                          {text_of(problem.upper[i])},
                          {text_of(problem.start[i])}});
  }
  return table;
}

report::Table table_of_best(const Family& family) {
  report::Table table{
      "What is known: true values at the start and at the best point. A violation is how "
      "much the largest true constraint is above 0.",
      {{"problem", Alignment::left},
       {"at the start"},
       {"best known"},
       {"at", Alignment::left},
       {"found by", Alignment::left}},
      {}};
  for (const Problem& problem : family.problems) {
    table.rows.push_back({{problem.name},
                          {text_of(truth_at(problem, problem.start))},
                          {report::text_or_dash(problem.best_known, "{:.6g}")},
                          {problem.best_point ? text_of(*problem.best_point) : "–"},
                          {problem.provenance.empty() ? "–" : problem.provenance}});
  }
  return table;
}

/// What a solver sees of a problem of one variable, and what is true.
report::Figure chart_of(const Family& family) {
  const Problem& problem = family.problems.at(family.problems.size() > 3 ? 3 : 0);
  const bool constrained = problem.constraints > 0;
  report::Chart chart;
  chart.name = "problem-" + family.name;
  chart.title = problem.name;
  const Variable variable =
      problem.variables.empty() ? Variable{"x", ""} : problem.variables.front();
  chart.x = {
      variable.unit.empty() ? variable.name : fmt::format("{} [{}]", variable.name, variable.unit),
      report::Scale::linear, report::Range{problem.lower[0], problem.upper[0]}};
  chart.y = {constrained ? "constraint, quiet up to 0" : "objective"};
  const Mark mark = problem.truth ? Mark::line : Mark::steps;
  report::Series shown{problem.truth ? "as a solver sees it" : "", mark, {}};
  report::Series truth{"in truth", Mark::steps, {}};
  for (int k = 0; k <= chart_samples; ++k) {
    const Vector x =
        problem.lower + (problem.upper - problem.lower) * static_cast<double>(k) / chart_samples;
    const Values values = problem.evaluate(x);
    shown.samples.push_back({x[0], constrained ? values.constraints[0] : values.objective});
    if (!problem.truth) continue;
    const Truth t = problem.truth(x);
    if (!constrained || t.violation > 0) {
      truth.samples.push_back({x[0], constrained ? t.violation : t.objective});
    } else {
      truth.samples.push_back({x[0], 0.0});
    }
  }
  if (problem.truth) chart.series.push_back(std::move(truth));
  chart.series.push_back(std::move(shown));
  if (constrained) chart.lines = {{report::Direction::horizontal, 0.0, "limit"}};
  if (problem.best_point) {
    chart.lines.push_back({report::Direction::vertical, (*problem.best_point)[0], "best known"});
  }
  chart.width = 780;
  return {chart, constrained && problem.truth
                     ? "The true constraint is shown as its violation, 0 where there is none."
                     : ""};
}

}  // namespace

report::Page overview_of(const std::vector<Family>& families, const std::string& machines) {
  std::size_t problems = 0;
  for (const Family& family : families) problems += family.problems.size();
  report::Page page;
  page.title = "The problems";
  page.intro = {
      fmt::format("{} problems in {} families, of {}. Each family has a page of its own, in the "
                  "folder of its name beside this one. Whatever counts impacts counts them by one "
                  "definition, from one simulation.",
                  problems, families.size(), machines),
      "Solvers minimise. A constraint holds where it is at most 0. What a solver is shown may be "
      "smooth; it is judged by the truth, which families that are judged as one share, with its "
      "best values."};
  report::Section section{"families", "Families"};
  section.tables = {table_of_families(families)};
  page.sections = {std::move(section)};
  return page;
}

report::Page page_of(const Family& family) {
  report::Page page;
  page.title = family.title;
  page.intro = {family.question, family.formula};
  report::Section section{"facts", "What it is"};
  const auto add = [&section](const char* what, const std::string& text) {
    section.paragraphs.push_back(fmt::format("{}: {}", what, text.empty() ? "none." : text));
  };
  add("Constraints", family.constraints);
  add("Derivatives", family.derivatives);
  add("Instances", family.instances +
                       " Each has numbered instances: the box moved and reflected, the start drawn "
                       "anew, so that no solver gains from where things lie.");
  add("Who would use it", family.users);
  section.tables = {table_of_variables(family.problems.front()), table_of_best(family)};
  if (family.problems.front().dimension() == 1) section.figures = {chart_of(family)};
  page.sections = {std::move(section)};
  return page;
}

}  // namespace ricochet::studies::problems
