#pragma once

#include <string>

#include "problems/carrier_track/counting/recording.h"
#include "src/report/chart.h"

namespace ricochet::studies::reproduction {

/// x(t) of a recording with its path, between the walls: over turns of the driver plate where the
/// scene's window is in turns, else over time. `name` and `title` are the chart's.
report::Chart path_chart(const carrier_track::Scene& scene,
                         const carrier_track::Recording& recording, std::string name,
                         std::string title);

}  // namespace ricochet::studies::reproduction
