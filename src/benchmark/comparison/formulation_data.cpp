#include "src/benchmark/comparison/formulation_data.h"

#include <utility>

#include "src/benchmark/analysis/ceiling.h"
#include "src/benchmark/comparison/share_data.h"

namespace ricochet::studies::comparison {
using report::Json;

namespace {

void add_ceilings(Json& rows, const Comparison& comparison, const Group& group) {
  for (const std::size_t q : group.problems) {
    const Problem& problem = comparison.campaign->problems()[q];
    for (const Formulation& formulation : problem.formulations(comparison.part->smoothings)) {
      if (formulation.smoothing == 0 || formulation.penalised) continue;
      const auto found = ceiling(problem, formulation.smoothing);
      if (!found) continue;
      rows.push_back(
          {{"family", group.family},
           {"problem", problem.name},
           {"smoothing", formulation.smoothing},
           {"optimum", found->optimum},
           {"best", (*problem.best_point)[0]},
           {"distance", found->distance},
           {"optimality_gap", found->optimality_gap},
           {"solves", found->optimality_gap && *found->optimality_gap <= problem.tolerance}});
    }
  }
}

}  // namespace

Json formulation_data(const Comparison& comparison, const std::vector<Group>& groups) {
  Json rows = Json::array();
  for (const Group& group : groups) {
    for (const auto& [solver, formulations] : shares_by_formulation(comparison, group)) {
      if (formulations.size() < 2) continue;
      for (const auto& [formulation, share] : formulations) {
        Json row = {{"family", group.family},
                    {"solver", solver},
                    {"formulation", formulation},
                    {"runs", share.trials}};
        row.update(share_data(share));
        rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

Json ceiling_data(const Comparison& comparison, const std::vector<Group>& groups) {
  Json rows = Json::array();
  for (const Group& group : groups) add_ceilings(rows, comparison, group);
  return rows;
}

}  // namespace ricochet::studies::comparison
