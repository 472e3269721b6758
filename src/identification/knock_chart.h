#pragma once

#include <vector>

#include "problems/carrier_track/identification/knock_loss.h"
#include "src/report/chart.h"

namespace ricochet::studies::identification {

/// Two charts of how the point x explains a record: how much later than the nearest predicted
/// impact each knock is, against time; and the plate's angle at each knock, recorded or predicted,
/// against time.
std::vector<report::Chart> knock_charts(const carrier_track::KnockLoss& loss, const Vector& x);

}  // namespace ricochet::studies::identification
