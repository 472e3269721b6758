#pragma once

#include "src/contest/contest.h"
#include "src/report/json.h"

namespace ricochet::studies::contest {

/// Who leans to the ends of the box or to its middle: the share of runs that each solver solves of
/// the plan's questions with the best point at the lower end, in the middle, at the upper end, all
/// else being the same. Runs anew, with the plan's smallest budget.
report::Json twin_data(const ricochet::contest::ContestPlan& plan);

}  // namespace ricochet::studies::contest
