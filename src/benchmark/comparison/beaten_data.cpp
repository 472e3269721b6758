#include "src/benchmark/comparison/beaten_data.h"

#include <map>

namespace ricochet::studies::comparison {
namespace {

using report::Json;

struct Beaten {
  int runs = 0;
  double gap = 0;  // of the best run
  const Cell* cell = nullptr;
};

}  // namespace

Json beaten_data(const Campaign& campaign,
                 const std::vector<ricochet::comparison::CellResult>& results) {
  std::map<std::size_t, Beaten> beaten;
  for (const auto& result : results) {
    const std::size_t number = result.cell->problem;
    for (const auto& outcome : result.outcomes) {
      const double gap = outcome.verdict.optimality_gap.value_or(0);
      if (gap >= -campaign.problems()[number].tolerance) continue;
      Beaten& there = beaten[number];
      ++there.runs;
      if (gap < there.gap) {
        there.gap = gap;
        there.cell = &result.cell->cell;
      }
    }
  }
  Json rows = Json::array();
  for (const auto& [number, there] : beaten) {
    const Problem& problem = campaign.problems()[number];
    rows.push_back({{"problem", problem.name},
                    {"best_known", problem.best_known.value()},
                    {"gap", there.gap},
                    {"tolerance", problem.tolerance},
                    {"runs", there.runs},
                    {"solver", there.cell->solver},
                    {"formulation", there.cell->formulation}});
  }
  return rows;
}

}  // namespace ricochet::studies::comparison
