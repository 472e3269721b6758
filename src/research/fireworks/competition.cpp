#include "src/research/fireworks/competition.h"

#include "solvers/fireworks/fireworks_family.h"
#include "src/research/fireworks/errors.h"
#include "src/research/fireworks/published.h"
#ifdef RICOCHET_HAS_PAGMO
#include "src/research/fireworks/cec2013.h"
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
std::vector<Solver> contenders() {
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
  const std::vector<Solver> members = contenders();
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

}  // namespace ricochet::studies::fireworks
