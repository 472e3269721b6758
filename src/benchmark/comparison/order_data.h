#pragma once

#include "src/benchmark/comparison/group.h"
#include "src/benchmark/comparison/reported_part.h"

namespace ricochet::studies::comparison {

/// Is the ranking of the entries robust? Compares the order in every group with the one for other
/// seeds, for either half of the instances, for another formulation, for the largest budget instead
/// of the smallest, and for machines drawn around the problems' own, as far as the plan has parts
/// for it. `ratings` are those of the groups.
report::Json order_data(const Comparison& comparison, const std::vector<CellResult>& results,
                        const ReportedPart& part, const std::vector<Group>& groups,
                        const Ratings& ratings);

}  // namespace ricochet::studies::comparison
