#pragma once

#include "src/report/json.h"
#include "src/studies/contest/field.h"

namespace ricochet::studies::contest {

/// The four entrants of each field with the largest budgets that are cheapest by penalised cost, in
/// pairs. Of the differences of their median regrets, one a question, the Bayesian signed-rank test
/// with a question's tolerance (half a collision of a count) as the region of equivalence; and, of
/// the evaluations until their runs solve each question, Mann and Whitney's rank-sum test with
/// Holm's correction over all pairs and questions of the field: on how many each is surely faster.
/// Of the two cheapest also the difference of their attainment functions. Fields of one question or
/// one entrant are left out.
report::Json pair_data(const Campaign& campaign, const std::vector<Field>& fields);

}  // namespace ricochet::studies::contest
