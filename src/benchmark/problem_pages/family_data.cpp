#include "src/benchmark/problem_pages/family_data.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <toml++/toml.h>

#include <algorithm>

#include "embedded/families.h"
#include "ricochet/verdict.h"
#include "src/benchmark/experiment/campaign/problem_hash.h"
#include "src/benchmark/problem_pages/difficulty.h"
#include "src/core/instance.h"
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

/// The problem with the most constraints: it has every formulation of the family.
const Problem& most_constrained(const Family& family) {
  return *std::max_element(
      family.problems.begin(), family.problems.end(),
      [](const Problem& a, const Problem& b) { return a.constraints < b.constraints; });
}

Json formulations_of(const Problem& problem) {
  return report::list_of(problem.formulations(), [&](const Formulation& formulation) -> Json {
    const Problem formulated = problem.formulated(formulation);
    return {{"formulation", problem.name_of(formulation)},
            {"constraints", formulated.constraints},
            {"derivatives", static_cast<bool>(formulated.differentiate)},
            {"residuals", static_cast<bool>(formulated.residuals)}};
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

/// Points at which the difficulty is sampled: more where one is cheap.
int sampled_points(const Problem& problem, int simulations) {
  const int more = problem.dimension() == 1 ? 5 * simulations : simulations;
  return std::max(1, static_cast<int>(more / std::max(1.0, problem.cost)));
}

/// A row of the table. An objective to be maximised is minimised as its negative; `sign` restores
/// it.
Json row_of(const Problem& problem, double sign, int simulations) {
  const TrueValues start = true_values_at(problem, problem.start);
  Json row = {{"name", problem.name},
              {"hash", problem_hash(problem)},
              {"start", sign * start.objective},
              {"start_violation", start.violation > 0 ? Json(start.violation) : Json()},
              {"best_known", problem.best_known ? Json(sign * *problem.best_known) : Json()},
              {"shown_point", nullptr},
              {"more_coordinates", false},
              {"point", nullptr},
              {"at_ends", coordinates_at_ends(problem)},
              {"dimension", problem.dimension()},
              {"difficulty", nullptr},
              {"proven", nullptr},
              {"not_excluded", Json::array()},
              {"provenance", problem.provenance.empty() ? Json() : Json(problem.provenance)}};
  if (problem.best_point) {
    const Vector& point = *problem.best_point;
    row["shown_point"] = list_of(point.head(std::min(point.size(), coordinates_shown)));
    row["more_coordinates"] = point.size() > coordinates_shown;
    row["point"] = list_of(point);
  }
  const int points = sampled_points(problem, simulations);
  if (const auto difficulty = difficulty_of(problem, points)) {
    row["difficulty"] = {{"points", points},
                         {"feasible", difficulty->feasible_share},
                         {"solving", difficulty->solving_share},
                         {"solving_lower", difficulty->interval.lower},
                         {"solving_upper", difficulty->interval.upper},
                         {"random_search", Json()},
                         {"at_least", 1 / difficulty->interval.upper},
                         {"plateau", difficulty->plateau}};
    if (difficulty->random_search) row["difficulty"]["random_search"] = *difficulty->random_search;
  }
  if (problem.best_known && problem.not_excluded) {
    const std::vector<CoordinateRange> ranges = problem.not_excluded(*problem.best_known);
    row["proven"] = ranges.empty();
    row["not_excluded"] = report::list_of(ranges, [](const CoordinateRange& range) -> Json {
      return {{"from", range.from}, {"to", range.to}};
    });
  }
  return row;
}

/// The samples that a line needs to look as if drawn through all of them.
std::vector<report::Sample> corners_of(const std::vector<report::Sample>& samples) {
  constexpr double fineness = 2000;  // of the chart: half a pixel of a large screen
  const auto [least, most] =
      std::ranges::minmax_element(samples, {}, [](const auto& sample) { return *sample.value; });
  const double up = (*most->value - *least->value) / fineness;
  const double across = (samples.back().position - samples.front().position) / fineness;
  if (!(up > 0)) return {samples.front(), samples.back()};
  return report::simplified(samples, across, up);
}

/// The samples where a step begins, and the last one.
std::vector<report::Sample> steps_of(const std::vector<report::Sample>& samples) {
  std::vector<report::Sample> steps;
  for (const report::Sample& sample : samples) {
    const bool last = &sample == &samples.back();
    if (steps.empty() || last || sample.value != steps.back().value) steps.push_back(sample);
  }
  return steps;
}

/// The curve of one formulation over the problem's one variable: steps for a count, a line for a
/// surrogate.
Json curve_of(const Problem& problem, const Formulation& formulation) {
  const Problem formulated = problem.formulated(formulation);
  const bool constrained = formulated.constraints > 0;
  std::vector<report::Sample> samples;
  for (int k = 0; k <= chart_samples; ++k) {
    const Vector x =
        problem.lower + (problem.upper - problem.lower) * static_cast<double>(k) / chart_samples;
    const Values values = formulated.evaluate(x);
    samples.push_back({x[0], constrained ? values.constraints[0] : values.objective});
  }
  const auto points = formulation.smoothing > 0 ? corners_of(samples) : steps_of(samples);
  return {{"formulation", problem.name_of(formulation)},
          {"points", report::list_of(points, [](const report::Sample& point) {
             return Json{{"x", point.position}, {"value", point.value}};
           })}};
}

/// The chart of a problem of one variable: its true values, and the surrogate if it has one.
Json chart_of(const Family& family) {
  const Problem& problem = family.problems.at(family.problems.size() > 3 ? 3 : 0);
  const Json variable = variables_of(problem)[0];
  return {{"problem", problem.name},
          {"variable", problem.variables.empty() ? Json("x") : variable["name"]},
          {"unit", variable["unit"]},
          {"lower", problem.lower[0]},
          {"upper", problem.upper[0]},
          {"limit", problem.constraints > 0 ? Json(0) : Json()},
          {"true_values", curve_of(problem, {})},
          {"smoothed", problem.smoothed ? curve_of(problem, {problem.smoothing}) : Json()},
          {"best", problem.best_point ? Json((*problem.best_point)[0]) : Json()}};
}

/// The least and the largest value over the problems; `one` is true if they are equal.
template <class Of>
Json range_of(const Family& family, Of of) {
  const auto [least, most] =
      std::minmax_element(family.problems.begin(), family.problems.end(),
                          [&](const Problem& a, const Problem& b) { return of(a) < of(b); });
  return {{"least", of(*least)}, {"most", of(*most)}, {"one", of(*least) == of(*most)}};
}

/// Adds the text members of a table.
void add_texts(const toml::table& table, Json& texts) {
  for (const auto& [key, value] : table) {
    if (value.is_string()) texts[std::string(key.str())] = value.as_string()->get();
  }
}

/// The texts of a family in families.toml; only the name if it is not there.
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
  names["smoothing"] = family.problems.front().smoothing;
  for (Json& text : texts) text = report::filled(text.get<std::string>(), {&names});
  return texts;
}

}  // namespace

Json family_data(const Family& family, int simulations) {
  const Problem& first = family.problems.front();
  const Problem& constrained = most_constrained(family);
  Json data = {
      {"report", "family"},
      {"name", family.name},
      {"first", first.name},
      {"variables", variables_of(first)},
      {"shown", constrained.name},
      {"penalty_weight", constrained.constraints > 0 ? Json(constrained.penalty_weight) : Json()},
      {"formulations", formulations_of(constrained)},
      {"problems", Json::array()},
      {"charts", Json::array()}};
  data.update(texts_of(family));
  const double sign = data["maximised"] == "" ? 1 : -1;
  std::vector<Json> rows(family.problems.size());
  tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t i) {
    rows[i] = row_of(family.problems[i], sign, simulations);
  });
  data["problems"] = rows;
  if (first.dimension() == 1) data["charts"].push_back(chart_of(family));
  return data;
}

Json family_row(const Family& family) {
  Json formulations = formulations_of(most_constrained(family));
  const bool derivatives = std::any_of(
      formulations.begin(), formulations.end(),
      [](const Json& formulation) { return formulation["derivatives"].template get<bool>(); });
  return {{"name", family.name},
          {"title", texts_of(family)["title"]},
          {"problems", family.problems.size()},
          {"variables", range_of(family, [](const Problem& p) { return p.dimension(); })},
          {"constraints", range_of(family, [](const Problem& p) { return p.constraints; })},
          {"formulations", std::move(formulations)},
          {"derivatives", derivatives}};
}

}  // namespace ricochet::studies::problems
