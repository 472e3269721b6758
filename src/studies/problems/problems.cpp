#include "src/studies/problems/problems.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "embedded/families.h"
#include "ricochet/random.h"
#include "ricochet/run.h"
#include "src/analysis/statistics/intervals.h"
#include "src/core/instance.h"
#include "src/experiment/planned_runs.h"
#include "src/report/painted.h"
#include "src/report/text.h"

namespace ricochet::studies::problems {

namespace {

constexpr int points_of_a_plateau = 20;
constexpr double narrowest = 1e-6;  // box widths

/// What is simulated.
Vector simulated(const Problem& problem, const Vector& x) {
  const Values values = problem.evaluate(x);
  return problem.constraints > 0 ? values.constraints : Vector::Constant(1, values.objective);
}

/// The distance from x along a coordinate, in box widths, at which what is simulated changes first:
/// the first of narrowest, twice that and so on where it differs.
double plateau_at(const Problem& problem, const Vector& x, Eigen::Index i) {
  const double width = problem.upper[i] - problem.lower[i];
  const bool up = x[i] - problem.lower[i] < width / 2;  // to the farther end
  const Vector here = simulated(problem, x);
  double distance = narrowest;
  for (; distance < 0.5; distance *= 2) {
    Vector there = x;
    there[i] += (up ? distance : -distance) * width;
    if (simulated(problem, there) != here) break;
  }
  return std::min(distance, 1.0);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

std::optional<Difficulty> difficulty_of(const Problem& problem, int points) {
  if (!problem.best_known) return std::nullopt;
  Random random(seed_of(problem.name, "difficulty", 0, 0));
  int solving = 0, feasible = 0;
  std::vector<double> plateaus;
  for (int k = 0; k < points; ++k) {
    const Vector x = uniform_point(problem, random);
    const TrueValues values = true_values_at(problem, x);
    if (values.violation <= 0) {
      ++feasible;
      if (values.objective <= *problem.best_known + problem.tolerance) ++solving;
    }
    if (k % points_of_a_plateau == 0) {
      plateaus.push_back(plateau_at(problem, x, k / points_of_a_plateau % problem.dimension()));
    }
  }
  const double share = static_cast<double>(solving) / points;
  return Difficulty{share, wilson_interval(solving, points), static_cast<double>(feasible) / points,
                    solving > 0 ? std::optional(1 / share) : std::nullopt, median(plateaus)};
}

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

namespace ricochet::studies {

namespace {

using report::Json;

constexpr int simulations = 1000;  // of a problem, to see how hard it is

Json compute(const std::vector<Family>& families, const std::string& scene_file) {
  Json data = {{"suite", suite_version},    {"scene", Json()},       {"problems", 0}, {"kinds", 0},
               {"families", Json::array()}, {"pages", Json::array()}};
  if (!scene_file.empty()) data["scene"] = std::filesystem::path(scene_file).filename().string();
  std::size_t problems = 0;
  for (const Family& family : families) {
    if (family.problems.empty()) continue;
    problems += family.problems.size();
    data["families"].push_back(problems::family_row(family));
    data["pages"].push_back(
        {{"folder", family.name}, {"data", problems::family_data(family, simulations)}});
  }
  data["problems"] = problems;
  data["kinds"] = data["families"].size();
  return data;
}

}  // namespace

Study problems_study(const std::function<std::vector<Family>()>& families,
                     const std::string& scene_file) {
  return {"problems", "",
          [families, scene_file](bool /*quick*/) { return compute(families(), scene_file); }};
}

}  // namespace ricochet::studies
