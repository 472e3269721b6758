#pragma once

#include <vector>

#include "src/report/json.h"
#include "src/studies/contest/reported_part.h"

namespace ricochet::studies::contest {

/// For every family that is asked of a grid of machines, maps over their factors, all of one shape:
/// in `machines` the best known answers, in `machine_maps` how much each of its best competitors
/// solves. The factor that is named first has a column a level, the others a row a combination.
/// In `landscapes` what the questions of one variable and no constraint are truly worth, e.g. the
/// collisions over the speed, a row a machine.
report::Json machine_data(const Campaign& campaign, const std::vector<StoredStanding>& standings,
                          const std::vector<ReportedPart>& parts);

}  // namespace ricochet::studies::contest
