#pragma once

#include <vector>

#include "ricochet/solver.h"
#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/results.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// How the user's solvers did beside the others: `own_solvers`, a row for each of them and each
/// family with its largest budget, with the success rate of its entry, its interval, the number of
/// other solvers that solve fewer and more of the problems that both take (if these are at least
/// half of the family's), and on how many of these the difference is significant: Wilcoxon's
/// signed-rank test over problems, with Holm's correction over the solvers of the family, at 5 %.
/// `own_totals`, a row for each: the problems that it solved in most of its runs.
report::Json own_solver_data(const Campaign& campaign, const std::vector<EntrySet>& sets,
                             const std::vector<Solver>& suite);

/// Does the order hold on problems held out? For every group, with the largest budget: how well the
/// order of the ranked entries on half of the problems predicts that on the other half. `measured`
/// is false for a group with too few problems or entries.
report::Json held_out_data(const Comparison& comparison, const std::vector<Group>& groups);

using namespace ricochet::comparison;

/// Bias of entries towards the ends or the middle of the box: the share of runs that each solves of
/// the relocated-optimum variants with the best point at the lower end, in the middle and at the
/// upper end, for every part of the plan that relocates the optimum: in `relocated_optima` a row
/// for each entry, in `relocated` the number of problems and of variables.
report::Json relocated_optimum_data(const Campaign& campaign,
                                    const std::vector<CellResult>& results);

}  // namespace ricochet::studies::comparison
