#pragma once

#include <vector>

#include "src/benchmark/analysis/cell_results.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

/// How far two campaigns with complete runs order their entries alike: a row for each family of the
/// first that the second has, too, with the largest budget of each. `agreement`: see
/// agreement_of(), null where it cannot be said. `leader`: the first entry of the first campaign,
/// with `best`, its P(best) there, null for one problem, and `place`, its place in the second, null
/// if it is not ranked there. `other_leader`: the first of the second.
report::Json agreement_data(const Campaign& first, const std::vector<CellResult>& of_first,
                            const Campaign& second, const std::vector<CellResult>& of_second);

}  // namespace ricochet::studies::comparison
