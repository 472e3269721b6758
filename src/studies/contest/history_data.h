#pragma once

#include "src/studies/contest/group.h"

namespace ricochet::studies::contest {

/// How the suite ranked solvers before the form was a factor: each in the first form that it takes,
/// 100 evaluations, instances that were all alike to a solver in a box, all cases as one. Beside it
/// what this contest says of the same solver in the same form, and in its best one. Solvers that
/// did not take part then, or do not now, are left out.
report::Json history_data(const ContestPlan& plan, const std::vector<Standing>& standings,
                          const std::vector<Group>& groups);

}  // namespace ricochet::studies::contest
