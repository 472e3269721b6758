#pragma once

#include <vector>

#include "src/contest/contest.h"
#include "src/report/json.h"

namespace ricochet::studies::contest {

using ricochet::contest::ContestPlan;
using ricochet::contest::Standing;

/// Runs that did not come to their own end, a row for each standing and kind of failure, with the
/// command that makes the first of them again.
report::Json failure_data(const ContestPlan& plan, const std::vector<Standing>& standings);

}  // namespace ricochet::studies::contest
