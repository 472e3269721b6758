#include "src/research/fireworks/table_3.h"

#include "solvers/fireworks/fireworks.h"
#include "src/research/fireworks/benchmark_functions.h"
#include "src/research/fireworks/errors.h"
#include "src/research/fireworks/published.h"

namespace ricochet::studies::fireworks {
namespace {

using namespace ricochet::fireworks;
using report::Json;

constexpr Eigen::Index dimension = 30;
constexpr std::int64_t evaluations = 10'000;

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
  const auto errors = errors_of(entries, evaluations, runs, problem.name);
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
               {"evaluations", evaluations},
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
    const Problem problem = benchmark_function(row["function"].get<std::string>(), dimension);
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
