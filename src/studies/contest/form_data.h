#pragma once

#include "src/studies/contest/group.h"

namespace ricochet::studies::contest {

/// What the form does to a solver: of every solver that takes several, the share of runs that each
/// solves with the largest budget, family by family.
report::Json form_data(const ContestPlan& plan, const std::vector<Standing>& standings,
                       const std::vector<Group>& groups);

/// How far the optimum of the surrogate is from the best point, for every width that is shown:
/// whoever follows the surrogate to its end comes no nearer.
report::Json ceiling_data(const ContestPlan& plan, const std::vector<Group>& groups);

}  // namespace ricochet::studies::contest
