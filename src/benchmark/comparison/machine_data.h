#pragma once

#include <vector>

#include "src/benchmark/comparison/reported_part.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// For every family that is posed on a grid of machines, maps over their factors, all of one shape:
/// in `machines` the best known values, in `machine_maps` the share solved by each of its best
/// entries. The first factor has a column for each level, the others a row for each combination.
/// `landscapes` has the true objective of problems of one variable without constraints, e.g. the
/// collisions over the speed, a row for each machine.
report::Json machine_data(const Campaign& campaign, const std::vector<CellResult>& results,
                          const std::vector<ReportedPart>& parts);

}  // namespace ricochet::studies::comparison
