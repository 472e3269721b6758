#pragma once

#include "src/site/found_report.h"

namespace ricochet::site {

/// A contest as the front page shows it. Null where there is none.
///
///   families     name, and the least and the most variables and constraints of its questions
///   columns      of the rows: family (its index), budget (evaluations a variable; 0: the largest
///                of each family, in rows of the family "all"), place, solver, form, outside, best
///                (P(best)), targets with lower and upper, found (share of runs solved), never,
///                rank; then speed against accuracy, null where the contest has none of it:
///                evaluations for each variable, seconds, solved and error (median regret) with
///                their intervals; complete, whether it takes all questions that any takes
///   rows         a list of values each, by family, budget and place: the first 25, and beyond them
///                who has speed against accuracy or is from outside
///   curves       the share of targets reached over evaluations: family, budget, solver, form,
///                points [[evaluations for each variable, share], ...]
Json contest_data(const std::vector<FoundReport>& reports);

}  // namespace ricochet::site
