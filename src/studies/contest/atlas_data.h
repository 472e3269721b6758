#pragma once

#include "src/contest/stored_contest.h"
#include "src/report/json.h"

namespace ricochet::studies::contest {

using namespace ricochet::contest;

/// The failure atlas: for each machine and feature, the share of all runs that solved their
/// question, with Wilson's interval, how the others ended, and a command that makes one of them
/// again. With each question's largest budget.
report::Json atlas_data(const Campaign& campaign, const std::vector<StoredStanding>& standings);

}  // namespace ricochet::studies::contest
