#pragma once

#include "src/report/json.h"
#include "src/studies/contest/field.h"

namespace ricochet::studies::contest {

/// Evaluations for each variable until the question is solved, with restarts; infinite where no run
/// solved it.
double running_time(const Campaign& campaign, const StoredStanding& standing);

/// What a solver needs on a question: evaluations for each variable, mean over its runs, of which
/// one that did not solve it is charged ten times the budget (PAR10; Lindauer, van Rijn and
/// Kotthoff 2019, doi:10.1016/j.artint.2018.10.004).
double penalised_cost(const Campaign& campaign, const StoredStanding& standing);

/// The entrants of the least geometric mean of penalised costs, best first.
std::vector<const Entrant*> cheapest_first(const Campaign& campaign, const Field& field);

/// Of every field with the largest budgets, two entrants or more and two questions or more:
/// performance profiles of expected running times of the six that are cheapest by penalised cost;
/// of all entrants how often each is within a factor of the least, how often it beats all others,
/// and how many times the virtual best's penalised cost its own is.
report::Json profile_data(const Campaign& campaign, const std::vector<Field>& fields);

}  // namespace ricochet::studies::contest
