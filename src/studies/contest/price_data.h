#pragma once

#include "src/contest/stored_contest.h"
#include "src/report/json.h"

namespace ricochet::studies::contest {

using namespace ricochet::contest;

/// Who is first under each price of a gradient, part by part and family by family, with the largest
/// budget, and how alike the order is to that under the price n. Empty where a part has one price.
report::Json price_data(const Campaign& campaign, const std::vector<StoredStanding>& standings);

}  // namespace ricochet::studies::contest
