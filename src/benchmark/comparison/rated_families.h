#pragma once

#include <vector>

#include "src/benchmark/analysis/cell_results.h"
#include "src/benchmark/analysis/rated_family.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

/// The families of a campaign with complete runs, by name, as its report names and ranks them.
std::vector<RatedFamily> rated_families(const Campaign& campaign,
                                        const std::vector<CellResult>& results);

}  // namespace ricochet::studies::comparison
