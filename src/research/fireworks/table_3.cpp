#include "src/studies/fireworks/table_3.h"

#include "solvers/fireworks/fireworks.h"
#include "src/studies/fireworks/benchmark_functions.h"
#include "src/studies/fireworks/errors.h"
#include "src/studies/fireworks/published.h"

namespace ricochet::studies::fireworks {
namespace {

using namespace ricochet::fireworks;
using report::Json;

constexpr Eigen::Index dimension = 30;
constexpr std::int64_t evaluations = 10'000;

/// Below this a mean is 0.000000.
constexpr double zero = 5e-7;

struct Reading {
  const char* name;
  FireworksOptions options;
};

/// Tan and Zhu's paper rounds where their program takes the ceiling.
FireworksOptions rounded_options() {
  FireworksOptions options = authors_options();
  options.moved = options.gaussian_moved = Moved::rounded;
  return options;
}

/// Of the algorithm of 2010.
std::vector<Reading> readings() {
  return {{"fireworks", paper_options()},
          {"fireworks-authors", authors_options()},
          {"with round(d U)", rounded_options()}};
}

/// That do not favour the origin.
std::vector<Reading> successors() {
  return {{"fireworks-corrected", corrected_options()}, {"efwa", enhanced_options()}};
}

/// The moments of each reading's errors, by its name.
Json cells_of(const std::vector<Reading>& readings, const Problem& problem, const Json& row,
              int runs) {
  std::vector<Contestant> contestants;
  for (Reading reading : readings) {
    reading.options.start_region = {row["lower"].get<double>(), row["upper"].get<double>()};
    contestants.push_back({ricochet::fireworks::fireworks(reading.name, reading.options),
                           [problem] { return problem; }});
  }
  const auto errors = errors_of(contestants, evaluations, runs, problem.name);
  Json cells = Json::array();
  for (std::size_t i = 0; i < readings.size(); ++i) {
    cells.push_back({{"name", readings[i].name}});
    cells.back().update(moments_of(errors[i]));
  }
  return cells;
}

/// Says of each cell whether it agrees with what was published.
void compare(Json& cells, const Json& row, int published_runs) {
  const double mean = row["mean"].get<double>();
  for (Json& cell : cells) {
    cell["agrees"] = mean < zero
                         ? cell["mean"].get<double>() < zero
                         : agrees(cell, {mean, published_runs, row["deviation"].get<double>()});
  }
}

}  // namespace

Json table_3_data(int runs) {
  const Json& table = published()["table_3"];
  Json data = {{"source", table["source"]},
               {"evaluations", evaluations},
               {"runs", runs},
               {"published_runs", table["runs"]},
               {"readings", Json::array()},
               {"successors", Json::array()},
               {"zeros", 0},
               {"others", Json::array()},
               {"rows", Json::array()}};
  for (const Reading& reading : readings()) {
    data["readings"].push_back({{"name", reading.name}, {"zeros", 0}});
  }
  for (const Reading& reading : successors()) data["successors"].push_back(reading.name);
  int zeros = 0;
  for (Json row : table["rows"]) {
    const Problem problem = benchmark_function(row["function"].get<std::string>(), dimension);
    row["cells"] = cells_of(readings(), problem, row, runs);
    row["successors"] = cells_of(successors(), problem, row, runs);
    compare(row["cells"], row, table["runs"].get<int>());
    const bool is_zero = row["mean"].get<double>() < zero;
    zeros += is_zero ? 1 : 0;
    for (std::size_t i = 0; i < row["cells"].size() && is_zero; ++i) {
      Json& count = data["readings"][i]["zeros"];
      count = count.get<int>() + (row["cells"][i]["agrees"].get<bool>() ? 1 : 0);
    }
    if (!is_zero) data["others"].push_back(row);
    data["rows"].push_back(std::move(row));
  }
  data["zeros"] = zeros;
  return data;
}

}  // namespace ricochet::studies::fireworks
