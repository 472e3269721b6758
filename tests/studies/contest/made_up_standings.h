#pragma once

#include <utility>
#include <vector>

#include "src/studies/contest/reported_part.h"

namespace ricochet::studies::contest {

/// All cells of a campaign, each with the runs that `runs_of` makes up for it.
template <class RunsOf>
std::vector<StoredStanding> made_up_standings(const Campaign& campaign, const RunsOf& runs_of) {
  std::vector<StoredStanding> standings;
  for (const PlannedCell& cell : campaign.cells()) {
    StoredStanding standing{&cell, {}};
    standing.outcomes = runs_of(cell);
    standings.push_back(std::move(standing));
  }
  return standings;
}

}  // namespace ricochet::studies::contest
