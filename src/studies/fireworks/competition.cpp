#include "src/studies/fireworks/competition.h"

#include "solvers/fireworks/family.h"
#include "src/studies/fireworks/errors.h"
#include "src/studies/fireworks/published.h"
#ifdef RICOCHET_HAS_PAGMO
#include "src/studies/fireworks/cec2013.h"
#endif

namespace ricochet::studies::fireworks {
namespace {

using report::Json;

std::vector<Contestant> contestants_of(const Json& rows, const std::vector<Solver>& members) {
  std::vector<Contestant> contestants;
#ifdef RICOCHET_HAS_PAGMO
  for (const Json& row : rows) {
    const auto number = row["number"].get<unsigned>();
    for (const Solver& member : members) {
      contestants.push_back({member, [number] { return cec2013(number, 30); }});
    }
  }
#endif
  return contestants;
}

/// Those that the table has figures of.
std::vector<Solver> members_in(const Json& row) {
  std::vector<Solver> members;
  for (Solver& member : ricochet::fireworks::family()) {
    if (row.contains(member.name)) members.push_back(std::move(member));
  }
  return members;
}

}  // namespace

Json competition_data(int runs, std::int64_t evaluations) {
  const Json& table = published()["cec2013"];
  const std::vector<Solver> members = members_in(table["rows"][0]);
  const std::vector<Contestant> contestants = contestants_of(table["rows"], members);
  Json data = {{"source", table["source"]},
               {"evaluations", evaluations},
               {"runs", runs},
               {"published_runs", table["runs"]},
               {"solvers", report::list_of(members, &Solver::name)},
               {"agreeing", 0},
               {"compared", contestants.size()},
               {"rows", Json::array()}};
  if (contestants.empty()) return data;
  const auto errors = errors_of(contestants, evaluations, runs, "functions of CEC 2013");
  std::size_t next = 0;
  int agreeing = 0;
  for (const Json& row : table["rows"]) {
    Json cells = Json::array();
    for (const Solver& member : members) {
      Json cell = moments_of(errors[next++]);
      const double other = row[member.name].get<double>();
      cell["other"] = other;
      cell["agrees"] = agrees(cell, other, table["runs"].get<int>());
      agreeing += cell["agrees"].get<bool>() ? 1 : 0;
      cells.push_back(std::move(cell));
    }
    data["rows"].push_back(
        {{"number", row["number"]}, {"function", row["function"]}, {"cells", std::move(cells)}});
  }
  data["agreeing"] = agreeing;
  return data;
}

}  // namespace ricochet::studies::fireworks
