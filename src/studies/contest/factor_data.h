#pragma once

#include "src/contest/stored_contest.h"
#include "src/report/json.h"

namespace ricochet::studies::contest {

using namespace ricochet::contest;

/// What restitution, friction and disturbance do to solvers, for the families asked of machines
/// that differ in all of them, with the largest budget and nothing disturbed:
/// - `effects`: main effects and interactions on the share solved, the cost (log10 of the
///   evaluations to solve, or spent) and the accuracy (share of targets reached), of each family's
///   five best competitors by share solved; the machine is the unit of the intervals;
/// - `turns`: who solves most at each level of each factor.
report::Json factor_data(const Campaign& campaign, const std::vector<StoredStanding>& standings);

}  // namespace ricochet::studies::contest
