#pragma once

#include "src/report/json.h"
#include "src/studies/contest/field.h"

namespace ricochet::studies::contest {

/// Speed against accuracy. `speed_accuracy` has a row for each solver, in its best form, for each
/// family and budget that a part of the plan asks:
///
///   family (as in the rest of the report), part (from 1), budget (evaluations a variable), largest
///   (none is larger), solver, form, questions, complete (it takes all that anybody takes there),
///   runs, evaluations   for each variable, until a run solved its question or in all: mean over
///   the runs
///                 of a question, geometric mean over questions
///   seconds       of processor time, the same mean
///   share, share_lower, share_upper     of runs that solved, mean over questions; the interval is
///                 over questions, or of one question over its runs that differ
///   regret, regret_lower, regret_upper  median of the questions' medians, in the question's unit;
///                 null where it is infinite, the interval also where fewer than 6 questions tell,
///                 or of one question runs
///   on_front, on_time_front   no complete one is better in evaluations (seconds) and share
///
/// Rows of the family "all", with budget and regret null, join the families of which at least
/// half of all solvers take all questions, with the largest budgets. `speed_accuracy_charts` has
/// what is drawn: of each family the largest budgets, and all together also against seconds;
/// `speed_accuracy_front` the rows on its fronts.
report::Json speed_accuracy_data(const Campaign& campaign, const std::vector<Field>& fields);

}  // namespace ricochet::studies::contest
