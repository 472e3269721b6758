#pragma once

#include "src/benchmark/analysis/cell_results.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

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
