#include "src/studies/fireworks/study.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <stdexcept>

#include "embedded/published.h"
#include "solvers/fireworks/dynamic_fireworks.h"
#include "solvers/fireworks/fireworks.h"
#include "solvers/library_solvers.h"
#include "src/analysis/statistics/intervals.h"
#include "src/core/progress.h"

#ifdef RICOCHET_HAS_PAGMO
#endif

namespace ricochet::studies::fireworks {

namespace {

using report::Json;

std::vector<Entry> entries_of(const Json& rows, const std::vector<Solver>& members) {
  std::vector<Entry> entries;
#ifdef RICOCHET_HAS_PAGMO
  for (const Json& row : rows) {
    const auto number = row["number"].get<unsigned>();
    for (const Solver& member : members) {
      entries.push_back({member, [number] { return cec2013(number, 30); }});
    }
  }
#endif
  return entries;
}

/// All except the interpretations of the paper, which are at most as good as Tan and Zhu's program.
std::vector<Solver> members_to_compare() {
  std::vector<Solver> members;
  for (Solver& member : ricochet::fireworks::family()) {
    const bool interpretation = member.name == "fireworks" || member.name == "fireworks-as-printed";
    if (!interpretation) members.push_back(std::move(member));
  }
  return members;
}

/// Our moments and the published mean, if there is one.
Json cell_of(const std::vector<double>& errors, const Json& row, const std::string& solver,
             int published_runs) {
  const Moments moments = moments_of(errors);
  Json cell = moments;
  const bool compared = row.contains(solver);
  cell["other"] = compared ? row[solver] : Json();
  cell["agrees"] =
      compared ? Json(agrees(moments, {row[solver].get<double>(), published_runs})) : Json();
  return cell;
}

}  // namespace

Json competition_data(int runs, std::int64_t evaluations) {
  const Json& table = published()["cec2013"];
  const std::vector<Solver> members = members_to_compare();
  const std::vector<Entry> entries = entries_of(table["rows"], members);
  Json data = {{"source", table["source"]},
               {"evaluations", evaluations},
               {"runs", runs},
               {"published_runs", table["runs"]},
               {"solvers", report::list_of(members, &Solver::name)},
               {"rows", Json::array()}};
  std::vector<std::vector<double>> errors;
  if (!entries.empty()) {
    errors = errors_of(entries, evaluations, runs, "functions of CEC 2013");
  }
  int compared = 0, agreeing = 0;
  for (std::size_t k = 0; k < entries.size(); k += members.size()) {
    Json row = table["rows"][k / members.size()];
    Json cells = Json::array();
    for (std::size_t i = 0; i < members.size(); ++i) {
      cells.push_back(cell_of(errors[k + i], row, members[i].name, table["runs"].get<int>()));
      compared += cells.back()["agrees"].is_boolean() ? 1 : 0;
      agreeing += cells.back()["agrees"] == true ? 1 : 0;
    }
    row["cells"] = std::move(cells);
    data["rows"].push_back(std::move(row));
  }
  data["compared"] = compared;
  data["agreeing"] = agreeing;
  return data;
}

namespace {

constexpr double negligible = 1e-8;

/// Quantile of Student's t for a two-sided 95 % interval of the mean of `degrees + 1` values, in
/// standard errors.
double student_t(double degrees) {
  return boost::math::quantile(boost::math::students_t(degrees), 0.975);
}

}  // namespace

std::vector<std::vector<double>> errors_of(const std::vector<Entry>& entries,
                                           std::int64_t evaluations, int runs,
                                           const std::string& progress) {
  std::vector<std::vector<double>> errors(entries.size(),
                                          std::vector<double>(static_cast<std::size_t>(runs)));
  Progress shown(progress, static_cast<double>(entries.size()) * runs);
  tbb::parallel_for(
      std::size_t{0}, entries.size() * static_cast<std::size_t>(runs), [&](std::size_t k) {
        const std::size_t number = k / entries.size();
        const std::size_t which = k % entries.size();
        const Entry& entry = entries[which];
        const RunRecord record =
            run(entry.problem(), entry.solver, {evaluations}, static_cast<int>(number) + 1);
        if (!record.failure.empty()) throw std::runtime_error(record.failure);
        errors[which][number] = record.trace.back().true_values.objective;
        shown.advance(1);
      });
  return errors;
}

Moments moments_of(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  double mean = 0;
  for (const double value : values) mean += value / count;
  double variance = 0;
  for (const double value : values) variance += (value - mean) * (value - mean) / (count - 1);
  const double deviation = std::sqrt(variance);
  const double reach = student_t(count - 1) * deviation / std::sqrt(count);
  return {mean, deviation, values.size(), mean - reach, mean + reach};
}

bool agrees(const Moments& moments, const OtherMean& other) {
  const auto runs = static_cast<double>(moments.runs);
  const double other_deviation = other.deviation.value_or(moments.deviation);
  const double error =
      std::hypot(moments.deviation / std::sqrt(runs), other_deviation / std::sqrt(other.runs));
  const double apart = std::abs(moments.mean - other.mean);
  return apart <= std::max(student_t(runs - 1) * error, negligible);
}

namespace {

constexpr std::int64_t plateau_evaluations = 1000;

template <class OfDistance>
Problem landscape(std::string name, double target, OfDistance of_distance) {
  Problem problem;
  problem.name = std::move(name);
  problem.source = "the study of the fireworks family";
  problem.lower = Vector::Zero(1);
  problem.upper = Vector::Constant(1, 1000);
  problem.start = Vector::Constant(1, 700);
  problem.evaluate = [target, of_distance](const Vector& x) {
    return Values{of_distance(std::max({target - x[0], x[0] - target - 1, 0.0})), {}};
  };
  return problem;
}

std::vector<Solver> contenders() {
  std::vector<Solver> solvers = ricochet::fireworks::family();
  solvers.push_back(ricochet::fireworks::bare_bones_fireworks("bbfwa-10", {.sparks = 10}));
  solvers.push_back(ricochet::fireworks::bare_bones_fireworks(
      "bbfwa-10-neutral", {.sparks = 10, .neutral_moves = true}));
  solvers.push_back(random_search());
  return solvers;
}

Json cell_of(const std::vector<double>& errors) {
  const auto hits = static_cast<double>(std::count(errors.begin(), errors.end(), 0.0));
  const auto runs = static_cast<double>(errors.size());
  const Interval interval = wilson_interval(hits, runs);
  return {{"rate", hits / runs},
          {"lower", interval.lower},
          {"upper", interval.upper},
          {"other", nullptr}};
}

/// Adds the published results to ours.
void add_published(const std::string& landscape, Json& solvers) {
  for (const Json& row : published()["plateau"]["rows"]) {
    if (row["landscape"] != landscape) continue;
    for (Json& solver : solvers) {
      if (solver["solver"] != row["solver"]) continue;
      for (std::size_t k = 0; k < row["rates"].size(); ++k) {
        solver["cells"][k]["other"] = row["rates"][k];
      }
    }
  }
}

}  // namespace

Problem needle(double target) {
  return landscape("needle", target, [](double distance) { return distance > 0 ? 1.0 : 0.0; });
}

Problem logarithmic_staircase(double target) {
  return landscape("logarithmic staircase", target,
                   [](double distance) { return std::ceil(std::log2(1 + distance)); });
}

Json plateau_data(int runs) {
  const Json& targets = published()["plateau"]["targets"];
  std::vector<Entry> entries;
  for (const auto& make : {needle, logarithmic_staircase}) {
    for (const Solver& solver : contenders()) {
      for (const Json& target : targets) {
        const Problem problem = make(target.get<double>());
        entries.push_back({solver, [problem] { return problem; }});
      }
    }
  }
  const auto errors = errors_of(entries, plateau_evaluations, runs, "plateaus");
  Json landscapes = Json::array();
  std::size_t next = 0;
  for (const auto& make : {needle, logarithmic_staircase}) {
    Json solvers = Json::array();
    for (const Solver& solver : contenders()) {
      Json cells = Json::array();
      for (std::size_t k = 0; k < targets.size(); ++k) cells.push_back(cell_of(errors[next++]));
      solvers.push_back({{"solver", solver.name}, {"cells", std::move(cells)}});
    }
    const std::string name = make(0).name;
    add_published(name, solvers);
    landscapes.push_back({{"id", next == errors.size() ? "staircase" : "needle"},
                          {"landscape", name},
                          {"solvers", std::move(solvers)}});
  }
  return {{"source", published()["plateau"]["source"]},
          {"evaluations", plateau_evaluations},
          {"runs", runs},
          {"targets", targets},
          {"landscapes", std::move(landscapes)}};
}

const report::Json& published() {
  static const report::Json all = report::Json::parse(embedded::published);
  return all;
}

namespace {

using namespace ricochet::fireworks;

constexpr Eigen::Index table_dimension = 30;
constexpr std::int64_t table_evaluations = 10'000;

/// A mean below this is printed as 0.000000.
constexpr double zero = 5e-7;

struct Interpretation {
  const char* name;
  FireworksOptions options;
};

/// Tan and Zhu's paper rounds; their program rounds up.
FireworksOptions rounded_options() {
  FireworksOptions options = authors_options();
  options.moved = options.gaussian_moved = Moved::rounded;
  return options;
}

/// Interpretations of the algorithm of 2010.
std::vector<Interpretation> interpretations() {
  return {{"fireworks", paper_options()},
          {"fireworks-authors", authors_options()},
          {"with round(d U)", rounded_options()}};
}

/// Successors without a bias to the origin.
std::vector<Interpretation> successors() {
  return {{"fireworks-corrected", corrected_options()}, {"efwa", enhanced_options()}};
}

/// The moments of each interpretation's errors, by its name.
Json cells_of(const std::vector<Interpretation>& interpretations, const Problem& problem,
              const Json& row, int runs) {
  std::vector<Entry> entries;
  for (Interpretation interpretation : interpretations) {
    interpretation.options.start_region = {row["lower"].get<double>(), row["upper"].get<double>()};
    entries.push_back({ricochet::fireworks::fireworks(interpretation.name, interpretation.options),
                       [problem] { return problem; }});
  }
  const auto errors = errors_of(entries, table_evaluations, runs, problem.name);
  Json cells = Json::array();
  for (std::size_t i = 0; i < interpretations.size(); ++i) {
    cells.push_back({{"name", interpretations[i].name}});
    cells.back().update(Json(moments_of(errors[i])));
  }
  return cells;
}

/// Adds to each cell whether it agrees with the published value.
void compare(Json& cells, const Json& row, int published_runs) {
  const double mean = row["mean"].get<double>();
  for (Json& cell : cells) {
    cell["agrees"] = mean < zero ? cell["mean"].get<double>() < zero
                                 : agrees(cell.get<Moments>(),
                                          {mean, published_runs, row["deviation"].get<double>()});
  }
}

}  // namespace

Json table_3_data(int runs) {
  const Json& table = published()["table_3"];
  Json data = {{"source", table["source"]},
               {"evaluations", table_evaluations},
               {"runs", runs},
               {"published_runs", table["runs"]},
               {"interpretations", Json::array()},
               {"successors", Json::array()},
               {"zeros", 0},
               {"others", Json::array()},
               {"rows", Json::array()}};
  for (const Interpretation& interpretation : interpretations()) {
    data["interpretations"].push_back({{"name", interpretation.name}, {"zeros", 0}});
  }
  for (const Interpretation& interpretation : successors())
    data["successors"].push_back(interpretation.name);
  int zeros = 0;
  for (Json row : table["rows"]) {
    const Problem problem = benchmark_function(row["function"].get<std::string>(), table_dimension);
    row["cells"] = cells_of(interpretations(), problem, row, runs);
    row["successors"] = cells_of(successors(), problem, row, runs);
    compare(row["cells"], row, table["runs"].get<int>());
    const bool is_zero = row["mean"].get<double>() < zero;
    zeros += is_zero ? 1 : 0;
    for (std::size_t i = 0; i < row["cells"].size() && is_zero; ++i) {
      Json& count = data["interpretations"][i]["zeros"];
      count = count.get<int>() + (row["cells"][i]["agrees"].get<bool>() ? 1 : 0);
    }
    if (!is_zero) data["others"].push_back(row);
    data["rows"].push_back(std::move(row));
  }
  data["zeros"] = zeros;
  return data;
}

}  // namespace ricochet::studies::fireworks

namespace ricochet::studies {

namespace {

report::Json compute(bool quick) {
  using namespace fireworks;
  return {{"table_3", table_3_data(quick ? 5 : 20)},
          {"shift", shift_data(quick ? 5 : 20)},
          {"competition", competition_data(quick ? 2 : 15, 300'000)},
          {"plateau", plateau_data(quick ? 100 : 1000)}};
}

}  // namespace

Study fireworks_study() {
  return {"fireworks", "Fewer runs, in a minute", compute};
}

}  // namespace ricochet::studies
