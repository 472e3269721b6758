#pragma once

#include <vector>

#include "ricochet/solver.h"
#include "src/benchmark/comparison/entry_set.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// Returns the data of the page on which a reader filters the runs: `view`, a compact table of all
/// runs, and `families`, a row for each family of the table, for readers.
///
/// The view has lists of names, which its `entries` count from 0: `families` (of problems, as the
/// report names them), `problems`, `solvers`, `formulations`, `perturbations` and `prices` of a
/// gradient. An entry is a solver-formulation pair on one family under one perturbation, price and
/// budget (evaluations for each variable). Its member `problems` has a 1 for each problem of the
/// family that it takes and a 0 for others, or is empty if it takes all. Its runs are in the order
/// of the problems, then of the instances, then of the seeds; how they are written is in
/// view_run.h. `orders` has a text for each family, perturbation, price and budget, in the order of
/// the entries: how the runs that miss targets are ranked, see view_order.h. A family's `joint` is
/// the budget with which it is among "all", see joint_entry_set. A run is in the part of the plan
/// that asks for it first. `known`: the solvers of the suite.
report::Json view_data(const Campaign& campaign, const std::vector<CellResult>& results,
                       const std::vector<ReportedPart>& parts, const std::vector<EntrySet>& sets,
                       const std::vector<Solver>& known);

}  // namespace ricochet::studies::comparison
