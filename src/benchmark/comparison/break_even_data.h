#pragma once

#include <vector>

#include "src/benchmark/comparison/entry_set.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// For every set of entries that is compared, computes which solver is ahead at which cost of a
/// simulation, with a gradient that is free, at its measured price and at n evaluations: rows with
/// the ranges of cost, and the curves of every entry that is ahead somewhere. The runs are those at
/// the price n; only their requests are priced differently.
report::Json break_even_data(const Campaign& campaign, const std::vector<EntrySet>& sets);

}  // namespace ricochet::studies::comparison
