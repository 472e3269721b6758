#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/counting/recording.h"
#include "src/report/chart.h"

namespace ricochet::studies::reproduction {

inline constexpr double millimetre = 1e-3;  // [m]

/// x [mm] of a recording with its path, over turns of the driver plate where the scene's window is
/// in turns, else over time [s].
std::vector<report::Sample> path_samples(const carrier_track::Scene& scene,
                                         const carrier_track::Recording& recording);

/// The same as a chart with the walls. `name` and `title` are the chart's.
report::Chart path_chart(const carrier_track::Scene& scene,
                         const carrier_track::Recording& recording, std::string name,
                         std::string title);

}  // namespace ricochet::studies::reproduction
