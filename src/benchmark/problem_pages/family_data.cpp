#include "src/studies/problems/family_data.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>

#include "embedded/families.h"
#include "src/core/verdict.h"
#include "src/report/filled_text.h"
#include "src/report/simplified.h"

namespace ricochet::studies::problems {
namespace {

using report::Json;

constexpr int chart_samples = 720;
constexpr Eigen::Index coordinates_shown = 5;

Json list_of(const Vector& point) {
  return Json(std::vector<double>(point.data(), point.data() + point.size()));
}

/// The one with the most constraints, and so with every form that there is in the family.
const Question& most_constrained(const Family& family) {
  return *std::max_element(family.questions.begin(), family.questions.end(),
                           [](const Question& a, const Question& b) {
                             return a.stated.constraints < b.stated.constraints;
                           });
}

Json forms_of(const Question& question) {
  return report::list_of(question.forms(), [&](const Form& form) -> Json {
    const Problem problem = question.problem(form);
    return {{"form", question.name_of(form)},
            {"constraints", problem.constraints},
            {"derivatives", static_cast<bool>(problem.differentiate)},
            {"residuals", static_cast<bool>(problem.residuals)}};
  });
}

Json variables_of(const Problem& problem) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < problem.dimension(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Variable variable =
        k < problem.variables.size() ? problem.variables[k] : Variable{fmt::format("x{}", i), ""};
    rows.push_back({{"name", variable.name},
                    {"unit", variable.unit.empty() ? Json() : Json(variable.unit)},
                    {"lower", problem.lower[i]},
                    {"upper", problem.upper[i]},
                    {"start", problem.start[i]}});
  }
  return rows;
}

/// What is to be as large as possible has its negative minimised; it is shown as it is meant.
Json row_of(const Question& question, double sign) {
  const Problem& problem = question.stated;
  const Truth start = truth_at(problem, problem.start);
  Json row = {{"name", problem.name},
              {"start", sign * start.objective},
              {"start_violation", start.violation > 0 ? Json(start.violation) : Json()},
              {"best_known", problem.best_known ? Json(sign * *problem.best_known) : Json()},
              {"shown_point", nullptr},
              {"more_coordinates", false},
              {"point", nullptr},
              {"provenance", problem.provenance.empty() ? Json() : Json(problem.provenance)}};
  if (problem.best_point) {
    const Vector& point = *problem.best_point;
    row["shown_point"] = list_of(point.head(std::min(point.size(), coordinates_shown)));
    row["more_coordinates"] = point.size() > coordinates_shown;
    row["point"] = list_of(point);
  }
  return row;
}

/// What a line through the samples needs, to be drawn as if it had all of them.
std::vector<report::Sample> corners_of(const std::vector<report::Sample>& samples) {
  constexpr double fineness = 2000;  // of the chart: half a pixel of a large screen
  const auto [least, most] =
      std::ranges::minmax_element(samples, {}, [](const auto& sample) { return *sample.value; });
  const double up = (*most->value - *least->value) / fineness;
  const double across = (samples.back().position - samples.front().position) / fineness;
  if (!(up > 0)) return {samples.front(), samples.back()};
  return report::simplified(samples, across, up);
}

/// What steps need: where they begin, and the end.
std::vector<report::Sample> steps_of(const std::vector<report::Sample>& samples) {
  std::vector<report::Sample> steps;
  for (const report::Sample& sample : samples) {
    const bool last = &sample == &samples.back();
    if (steps.empty() || last || sample.value != steps.back().value) steps.push_back(sample);
  }
  return steps;
}

/// The question as a form of it is, over its one variable: a count's steps, a surrogate's line.
Json curve_of(const Question& question, const Form& form) {
  const Problem problem = question.problem(form);
  const bool constrained = problem.constraints > 0;
  std::vector<report::Sample> samples;
  for (int k = 0; k <= chart_samples; ++k) {
    const Vector x =
        problem.lower + (problem.upper - problem.lower) * static_cast<double>(k) / chart_samples;
    const Values values = problem.evaluate(x);
    samples.push_back({x[0], constrained ? values.constraints[0] : values.objective});
  }
  const auto points = form.width > 0 ? corners_of(samples) : steps_of(samples);
  return {{"form", question.name_of(form)},
          {"points", report::list_of(points, [](const report::Sample& point) {
             return Json{{"x", point.position}, {"value", point.value}};
           })}};
}

/// What is true of a question of one variable, and what a solver sees where it is smoothed.
Json chart_of(const Family& family) {
  const Question& question = family.questions.at(family.questions.size() > 3 ? 3 : 0);
  const Problem& stated = question.stated;
  const Json variable = variables_of(stated)[0];
  return {{"question", stated.name},
          {"variable", stated.variables.empty() ? Json("x") : variable["name"]},
          {"unit", variable["unit"]},
          {"lower", stated.lower[0]},
          {"upper", stated.upper[0]},
          {"limit", stated.constraints > 0 ? Json(0) : Json()},
          {"truth", curve_of(question, {})},
          {"smoothed", stated.smoothed ? curve_of(question, {question.width}) : Json()},
          {"best", stated.best_point ? Json((*stated.best_point)[0]) : Json()}};
}

/// The least and the most over the questions; `one` where they are the same.
template <class Of>
Json range_of(const Family& family, Of of) {
  const auto [least, most] = std::minmax_element(
      family.questions.begin(), family.questions.end(),
      [&](const Question& a, const Question& b) { return of(a.stated) < of(b.stated); });
  return {{"least", of(least->stated)},
          {"most", of(most->stated)},
          {"one", of(least->stated) == of(most->stated)}};
}

/// The members of a table that are texts.
void add_texts(const toml::table& table, Json& texts) {
  for (const auto& [key, value] : table) {
    if (value.is_string()) texts[std::string(key.str())] = value.as_string()->get();
  }
}

/// What families.toml says of a family; of one that it does not know, nothing but the name.
Json texts_of(const Family& family) {
  static const toml::table all = toml::parse(embedded::families);
  Json texts = {{"title", family.name}};
  for (const char* key : {"asks", "formula", "constraints", "surrogate", "derivatives", "instances",
                          "users", "maximised"}) {
    texts[key] = "";
  }
  if (const toml::table* own = all[family.name].as_table()) {
    if (const auto like = (*own)["like"].value<std::string>()) {
      add_texts(*all[*like].as_table(), texts);
    }
    add_texts(*own, texts);
  }
  Json names = texts;
  names["width"] = family.questions.front().width;
  for (Json& text : texts) text = report::filled(text.get<std::string>(), {&names});
  return texts;
}

}  // namespace

Json family_data(const Family& family) {
  const Question& first = family.questions.front();
  const Question& constrained = most_constrained(family);
  Json data = {{"report", "family"},
               {"name", family.name},
               {"first", first.name()},
               {"variables", variables_of(first.stated)},
               {"shown", constrained.name()},
               {"penalty_weight",
                constrained.stated.constraints > 0 ? Json(constrained.penalty_weight) : Json()},
               {"forms", forms_of(constrained)},
               {"questions", Json::array()},
               {"charts", Json::array()}};
  data.update(texts_of(family));
  const double sign = data["maximised"] == "" ? 1 : -1;
  for (const Question& question : family.questions) {
    data["questions"].push_back(row_of(question, sign));
  }
  if (first.stated.dimension() == 1) data["charts"].push_back(chart_of(family));
  return data;
}

Json family_row(const Family& family) {
  Json forms = forms_of(most_constrained(family));
  const bool derivatives = std::any_of(forms.begin(), forms.end(), [](const Json& form) {
    return form["derivatives"].template get<bool>();
  });
  return {{"name", family.name},
          {"title", texts_of(family)["title"]},
          {"questions", family.questions.size()},
          {"variables", range_of(family, [](const Problem& p) { return p.dimension(); })},
          {"constraints", range_of(family, [](const Problem& p) { return p.constraints; })},
          {"forms", std::move(forms)},
          {"derivatives", derivatives}};
}

}  // namespace ricochet::studies::problems
