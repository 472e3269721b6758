#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/recording.h"
#include "ricochet/recording.h"
#include "src/report/chart.h"

namespace ricochet::studies {

inline constexpr double millimetre = 1e-3;  // [m]

/// The abscissa of a path: turns of the driver plate if the scene's window is in turns, else time.
struct PathAxis {
  std::string label;
  double unit;  ///< [s]
};

PathAxis path_axis(const carrier_track::Scene& scene);

/// x [mm] along a recorded path.
std::vector<report::Sample> path_samples(const carrier_track::Scene& scene,
                                         const carrier_track::Recording& recording);

/// x [mm] of the recording's counted events: impacts or maxima.
std::vector<report::Sample> counted_samples(const carrier_track::Scene& scene,
                                            const carrier_track::Recording& recording);

/// The name of these events: "impact that counts" or "maximum that counts".
std::string counted_label(const carrier_track::Scene& scene);

/// The part of the path with most of the counted events, sampled finely.
struct PathZoom {
  report::Range at;  ///< along the path's axis
  report::Range x;   ///< [mm], with some room around the path
  std::vector<report::Sample> path;
};

/// Empty if no small part of the path has most of the events. Simulates again.
std::optional<PathZoom> path_zoom(const carrier_track::Scene& scene,
                                  const carrier_track::Recording& recording);

/// The path with its counted events, and the walls. `name` and `title` are the chart's.
report::Chart path_chart(const carrier_track::Scene& scene,
                         const carrier_track::Recording& recording, std::string name,
                         std::string title);

/// The chart of a zoomed part of the path.
report::Chart zoom_chart(const carrier_track::Scene& scene,
                         const carrier_track::Recording& recording, const PathZoom& zoom,
                         std::string name);

}  // namespace ricochet::studies
