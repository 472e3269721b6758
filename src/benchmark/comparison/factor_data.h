#pragma once

#include "src/report/json.h"
#include "src/studies/contest/reported_part.h"

namespace ricochet::studies::contest {

/// What restitution, friction, disturbance and fidelity do to solvers, for the families asked of
/// machines that differ in all of them, with the largest budget and nothing disturbed:
/// - `effects`: main effects and interactions on the share solved, the cost (log10 of the
///   evaluations to solve, or spent) and the accuracy (share of targets reached), of each family's
///   five best competitors by share solved; the machine is the unit of the intervals;
/// - `main_effects`: all main effects of these on the share solved, sure or not;
/// - `turns`: who solves most at each level of each factor.
report::Json factor_data(const Campaign& campaign, const std::vector<StoredStanding>& standings,
                         const std::vector<ReportedPart>& parts);

}  // namespace ricochet::studies::contest
