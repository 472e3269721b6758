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

std::vector<Reading> readings() {
  return {{"fireworks", paper_options()},
          {"fireworks-authors", authors_options()},
          {"... with round(d U)", rounded_options()},
          {"efwa", enhanced_options()},
          {"fireworks-corrected", corrected_options()}};
}

Json cell_of(const std::vector<double>& errors, const Json& row, int published_runs) {
  Json cell = moments_of(errors);
  const double mean = row["mean"].get<double>();
  cell["agrees"] =
      mean < zero ? cell["mean"].get<double>() < zero : agrees(cell, mean, published_runs);
  return cell;
}

}  // namespace

Json table_3_data(int runs) {
  const Json& table = published()["table_3"];
  std::vector<Contestant> contestants;
  for (const Json& row : table["rows"]) {
    const Problem problem = benchmark_function(row["function"].get<std::string>(), dimension);
    for (Reading reading : readings()) {
      reading.options.start_region = {row["lower"].get<double>(), row["upper"].get<double>()};
      contestants.push_back({ricochet::fireworks::fireworks(reading.name, reading.options),
                             [problem] { return problem; }});
    }
  }
  const auto errors = errors_of(contestants, evaluations, runs, "functions of 2010");
  Json data = {
      {"source", table["source"]},       {"evaluations", evaluations}, {"runs", runs},
      {"published_runs", table["runs"]}, {"readings", Json::array()},  {"rows", Json::array()}};
  for (const Reading& reading : readings()) {
    data["readings"].push_back({{"name", reading.name}, {"zeros", 0}});
  }
  std::size_t next = 0;
  int zeros = 0;
  for (Json row : table["rows"]) {
    const bool is_zero = row["mean"].get<double>() < zero;
    zeros += is_zero ? 1 : 0;
    row["cells"] = Json::array();
    for (Json& reading : data["readings"]) {
      row["cells"].push_back(cell_of(errors[next++], row, table["runs"].get<int>()));
      if (is_zero && row["cells"].back()["agrees"].get<bool>()) {
        reading["zeros"] = reading["zeros"].get<int>() + 1;
      }
    }
    data["rows"].push_back(std::move(row));
  }
  data["zeros"] = zeros;
  return data;
}

}  // namespace ricochet::studies::fireworks
