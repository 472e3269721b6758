#pragma once

#include "src/benchmark/comparison/reported_part.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// Effects of restitution, friction, disturbance and fidelity on solvers, for the families whose
/// machines differ in all of them, with the largest budget and without perturbations:
/// - `effects`: main effects and interactions on the share solved, the cost (log10 of the
///   evaluations to solve, or spent) and the accuracy (share of targets reached), of each family's
///   five best entries by share solved; the machine is the unit of the intervals;
/// - `main_effects`: all their main effects on the share solved, significant or not;
/// - `turns`: the entry that solves most at each level of each factor.
report::Json factor_data(const Campaign& campaign, const std::vector<CellResult>& results,
                         const std::vector<ReportedPart>& parts);

}  // namespace ricochet::studies::comparison
