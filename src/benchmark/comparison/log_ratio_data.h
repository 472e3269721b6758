#pragma once

#include <vector>

#include "src/benchmark/comparison/entry_set.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// For every set of entries that is compared and every problem: the ratio of the evaluations of its
/// two best entries, and which of them solves it, as bars in ascending order.
report::Json log_ratio_data(const Campaign& campaign, const std::vector<EntrySet>& sets);

}  // namespace ricochet::studies::comparison
