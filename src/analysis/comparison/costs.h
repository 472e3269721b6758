#pragma once

#include <vector>

#include "src/analysis/comparison/reported_part.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// For every set of entries that is compared, computes which solver is ahead at which cost of a
/// simulation, with a gradient that is free, at its measured price and at n evaluations: rows with
/// the ranges of cost, and the curves of every entry that is ahead somewhere. The runs are those at
/// the price n; only their requests are priced differently.
report::Json break_even_data(const Campaign& campaign, const std::vector<EntrySet>& sets);

/// Speed against accuracy. `speed_accuracy` has a row for each solver, in its best formulation, for
/// each family and budget in a part of the plan:
///
///    family (as in the rest of the report), part (from 1), budget (evaluations per variable),
///    largest (no budget is larger), solver, formulation, problems, complete (it takes all problems
///    that any solver takes there), runs
///    evaluations   per variable, until a run solved its problem, or all of them: mean over the
///                  runs of a problem, geometric mean over problems
///    seconds       of processor time, the same mean
///    share, share_lower, share_upper   of runs that solved, mean over problems; the interval is
///                  over problems, or over the runs that differ if there is one problem
///    optimality_gap, optimality_gap_lower, optimality_gap_upper   median of the problems' medians,
///                  in the problem's unit; null if infinite; the interval is also null with fewer
///                  than 6 problems, or than 6 runs of one problem
///    on_front, on_time_front   no complete one is better in evaluations (seconds) and share
///
/// Rows of the family "all", whose budget and optimality gap are null, join the families of which
/// at least half of all solvers take all problems, with the largest budgets.
/// `speed_accuracy_charts` has the data of the charts: for each family the largest budgets, and for
/// all together also against seconds; `speed_accuracy_front` has the rows on their
/// Pareto fronts that solved some run.
report::Json speed_accuracy_data(const Campaign& campaign, const std::vector<EntrySet>& sets);

}  // namespace ricochet::studies::comparison
