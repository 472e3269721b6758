#pragma once

#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/results.h"
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

using namespace ricochet::comparison;

/// Effects of perturbations on solvers, by family, with the largest budget. Each solver is in the
/// formulation that does best over all perturbations together; "plain" uses the same cells as the
/// perturbation:
/// - `perturbations`: a row for each perturbation: means over solvers with and without it, the
///   number of solvers that it harms significantly, the most harmed ones, and the one that solves
///   most under it;
/// - `perturbation_rows`: a row for each solver, with a success rate for each perturbation, the
///   problems and runs under each, and the variables of the problems;
/// - `atlas`: for every machine and perturbation the outcomes of the runs, and a command that
///   repeats one of the failed ones.
/// Lists are empty if the campaign has no perturbation but "plain".
report::Json perturbation_data(const Campaign& campaign, const std::vector<CellResult>& results);

}  // namespace ricochet::studies::comparison
