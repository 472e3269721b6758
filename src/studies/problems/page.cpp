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

/// The one with the most constraints, and so with every form that there is in the family.
const Question& most_constrained(const Family& family) {
  return *std::max_element(family.questions.begin(), family.questions.end(),
                           [](const Question& a, const Question& b) {
                             return a.stated.constraints < b.stated.constraints;
                           });
}

report::Table table_of_families(const std::vector<Family>& families) {
  report::Table table{"All families.",
                      {{"family", Alignment::left},
                       {"asks for", Alignment::left},
                       {"questions"},
                       {"variables"},
                       {"constraints"},
                       {"shown as", Alignment::left},
                       {"derivatives", Alignment::left}},
                      {}};
  for (const Family& family : families) {
    if (family.questions.empty()) continue;
    const auto range_of = [&family](const auto& of) {
      Eigen::Index fewest = of(family.questions.front().stated);
      Eigen::Index most = fewest;
      for (const Question& question : family.questions) {
        fewest = std::min(fewest, of(question.stated));
        most = std::max(most, of(question.stated));
      }
      return fewest == most ? fmt::format("{}", most) : fmt::format("{} to {}", fewest, most);
    };
    const Question& question = most_constrained(family);
    std::string forms;
    bool derivatives = false;
    for (const Form& form : question.forms()) {
      forms += (forms.empty() ? "" : ", ") + question.name_of(form);
      derivatives = derivatives || question.problem(form).differentiate;
    }
    table.rows.push_back({{family.name},
                          {family.title},
                          {fmt::format("{}", family.questions.size())},
                          {range_of([](const Problem& problem) { return problem.dimension(); })},
                          {range_of([](const Problem& problem) { return problem.constraints; })},
                          {forms},
                          {yes_or_no(derivatives)}});
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

report::Table table_of_forms(const Family& family) {
  const Question& question = most_constrained(family);
  std::string caption =
      fmt::format("The forms in which {} can be shown to a solver.", question.name());
  if (question.stated.constraints > 0) {
    caption +=
        fmt::format(" Penalised, each constraint adds {} times its violation to the objective.",
                    text_of(question.penalty_weight));
  }
  report::Table table{std::move(caption),
                      {{"shown as", Alignment::left},
                       {"constraints"},
                       {"derivatives", Alignment::left},
                       {"residuals", Alignment::left}},
                      {}};
  for (const Form& form : question.forms()) {
    const Problem problem = question.problem(form);
    table.rows.push_back({{question.name_of(form)},
                          {fmt::format("{}", problem.constraints)},
                          {yes_or_no(static_cast<bool>(problem.differentiate))},
                          {yes_or_no(static_cast<bool>(problem.residuals))}});
  }
  return table;
}

report::Table table_of_best(const Family& family) {
  report::Table table{
      "What is known: true values at the start and at the best point. A violation is how "
      "much the largest true constraint is above 0.",
      {{"question", Alignment::left},
       {"at the start"},
       {"best known"},
       {"at", Alignment::left},
       {"found by", Alignment::left}},
      {}};
  for (const Question& question : family.questions) {
    const Problem& problem = question.stated;
    table.rows.push_back({{problem.name},
                          {text_of(truth_at(problem, problem.start))},
                          {report::text_or_dash(problem.best_known, "{:.6g}")},
                          {problem.best_point ? text_of(*problem.best_point) : "–"},
                          {problem.provenance.empty() ? "–" : problem.provenance}});
  }
  return table;
}

/// What is true of a question of one variable, and what a solver sees where it is smoothed.
report::Figure chart_of(const Family& family) {
  const Question& question = family.questions.at(family.questions.size() > 3 ? 3 : 0);
  const Problem& stated = question.stated;
  const bool constrained = stated.constraints > 0;
  report::Chart chart;
  chart.name = "problem-" + family.name;
  chart.title = stated.name;
  const Variable variable = stated.variables.empty() ? Variable{"x", ""} : stated.variables.front();
  chart.x = {
      variable.unit.empty() ? variable.name : fmt::format("{} [{}]", variable.name, variable.unit),
      report::Scale::linear, report::Range{stated.lower[0], stated.upper[0]}};
  chart.y = {constrained ? "constraint, quiet up to 0" : "objective"};
  const auto add = [&](const Form& form, Mark mark) {
    const Problem problem = question.problem(form);
    report::Series series{question.name_of(form), mark, {}};
    for (int k = 0; k <= chart_samples; ++k) {
      const Vector x =
          problem.lower + (problem.upper - problem.lower) * static_cast<double>(k) / chart_samples;
      const Values values = problem.evaluate(x);
      series.samples.push_back({x[0], constrained ? values.constraints[0] : values.objective});
    }
    chart.series.push_back(std::move(series));
  };
  add({}, Mark::steps);
  if (stated.smoothed) add({question.width}, Mark::line);
  if (constrained) chart.lines = {{report::Direction::horizontal, 0.0, "limit"}};
  if (stated.best_point) {
    chart.lines.push_back({report::Direction::vertical, (*stated.best_point)[0], "best known"});
  }
  chart.width = 780;
  return {chart, ""};
}

}  // namespace

report::Page overview_of(const std::vector<Family>& families, const std::string& machines) {
  std::size_t questions = 0;
  for (const Family& family : families) questions += family.questions.size();
  report::Page page;
  page.title = "The problems";
  page.intro = {
      fmt::format("{} questions in {} families, of {}. Each family has a page of its own, in the "
                  "folder of its name beside this one. Whatever counts impacts counts them by one "
                  "definition, from one simulation.",
                  questions, families.size(), machines),
      "Solvers minimise. A constraint holds where it is at most 0. A question can be shown in "
      "several forms: as it is, or smoothed; with its constraints, or with a penalty for them. It "
      "is judged by the truth, which its forms share, with its best value."};
  report::Section section{"families", "Families"};
  section.tables = {table_of_families(families)};
  page.sections = {std::move(section)};
  return page;
}

report::Page page_of(const Family& family) {
  report::Page page;
  page.title = family.title;
  page.intro = {family.asks, family.formula};
  report::Section section{"facts", "What it is"};
  const auto add = [&section](const char* what, const std::string& text) {
    section.paragraphs.push_back(fmt::format("{}: {}", what, text.empty() ? "none." : text));
  };
  add("Constraints", family.constraints);
  add("Surrogate", family.surrogate);
  add("Derivatives", family.derivatives);
  add("Instances", family.instances +
                       " Each has numbered instances: the box moved and reflected, the start drawn "
                       "anew, so that no solver gains from where things lie.");
  add("Who would use it", family.users);
  section.tables = {table_of_variables(family.questions.front().stated), table_of_forms(family),
                    table_of_best(family)};
  if (family.questions.front().stated.dimension() == 1) section.figures = {chart_of(family)};
  page.sections = {std::move(section)};
  return page;
}

}  // namespace ricochet::studies::problems
