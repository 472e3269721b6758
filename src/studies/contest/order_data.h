#pragma once

#include "src/studies/contest/group.h"

namespace ricochet::studies::contest {

/// Whether the order of the competitors in every group would be another: with other seeds, with
/// either half of the instances, in another form, with the largest budget in place of the smallest.
/// `again` are the standings of the same plan with another run's seeds and its smallest budget. Top
/// speeds also with other machines: `drawn` is the plan of them. `ratings` are those of the groups.
report::Json order_data(const ContestPlan& plan, const std::vector<Standing>& standings,
                        const std::vector<Standing>& again, const ContestPlan& drawn,
                        const std::vector<Group>& groups, const Ratings& ratings);

}  // namespace ricochet::studies::contest
