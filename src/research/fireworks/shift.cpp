#include "src/research/fireworks/shift.h"

#include "solvers/fireworks/fireworks_family.h"
#include "src/research/fireworks/benchmark_functions.h"
#include "src/research/fireworks/errors.h"
#include "src/research/fireworks/published.h"

namespace ricochet::studies::fireworks {
namespace {

using report::Json;

constexpr Eigen::Index dimension = 30;
constexpr std::int64_t evaluations = 10'000;

/// An optimum at more than this distance from the origin is far; a solver that is much worse there
/// is biased.
constexpr double far = 30;
constexpr double much = 100;

}  // namespace

Json shift_data(int runs) {
  const Json& table = published()["shift"];
  const std::vector<Solver> members = ricochet::fireworks::family();
  std::vector<Entry> entries;
  for (const Solver& member : members) {
    for (const Json& row : table["rows"]) {
      const Problem problem = shifted_sphere(row["shift"].get<double>(), dimension);
      entries.push_back({member, [problem] { return problem; }});
    }
  }
  const auto errors = errors_of(entries, evaluations, runs, "shifted sphere");
  Json data = {
      {"source", table["source"]}, {"evaluations", evaluations}, {"runs", runs},
      {"shifts", table["rows"]},   {"solvers", Json::array()},   {"biased", Json::array()}};
  std::size_t next = 0;
  for (const Solver& member : members) {
    Json cells = Json::array();
    for (const Json& row : table["rows"]) {
      Json cell = moments_of(errors[next++]);
      cell["shift"] = row["shift"];
      cells.push_back(std::move(cell));
    }
    double worst_far = 0;
    for (const Json& cell : cells) {
      if (cell["shift"].get<double>() >= far) {
        worst_far = std::max(worst_far, cell["mean"].get<double>());
      }
    }
    const bool biased = worst_far > much * cells[0]["mean"].get<double>();
    if (biased) data["biased"].push_back(member.name);
    data["solvers"].push_back({{"solver", member.name}, {"fair", !biased}, {"cells", cells}});
  }
  return data;
}

}  // namespace ricochet::studies::fireworks
