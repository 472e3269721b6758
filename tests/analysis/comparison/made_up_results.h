#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "src/analysis/comparison/reported_part.h"

namespace ricochet::studies::comparison {

/// All cells of a campaign, each with the runs that `runs_of` makes up for it.
template <class RunsOf>
std::vector<CellResult> made_up_results(const Campaign& campaign, const RunsOf& runs_of) {
  std::vector<CellResult> results;
  for (const PlannedCell& cell : campaign.cells()) {
    const Problem& problem = campaign.problems()[cell.problem];
    CellResult result{&cell, {}, std::make_shared<const Targets>(targets_of(problem))};
    result.outcomes = runs_of(cell);
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace ricochet::studies::comparison
