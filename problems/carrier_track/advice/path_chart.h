#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/recording.h"
#include "src/report/chart.h"

namespace ricochet::studies {

inline constexpr double millimetre = 1e-3;  // [m]

/// What a path is drawn over: turns of the driver plate where the scene's window is in turns, else
/// time.
struct PathAxis {
  std::string label;
  double unit;  ///< [s]
};

PathAxis path_axis(const carrier_track::Scene& scene);

/// x [mm] of a recording with its path.
std::vector<report::Sample> path_samples(const carrier_track::Scene& scene,
                                         const carrier_track::Recording& recording);

/// Where the recording has what counts: x [mm] of its impacts or of its maxima.
std::vector<report::Sample> counted_samples(const carrier_track::Scene& scene,
                                            const carrier_track::Recording& recording);

/// What these are called: "impact that counts".
std::string counted_label(const carrier_track::Scene& scene);

/// Where most of what counts happens: a part of the path, drawn finely enough for itself.
struct PathZoom {
  report::Range at;  ///< along the path's axis
  report::Range x;   ///< [mm], with some room around the path
  std::vector<report::Sample> path;
};

/// Nothing where no small part of the path has most of it. Simulates again.
std::optional<PathZoom> path_zoom(const carrier_track::Scene& scene,
                                  const carrier_track::Recording& recording);

/// The path with what counts, and the walls. `name` and `title` are the chart's.
report::Chart path_chart(const carrier_track::Scene& scene,
                         const carrier_track::Recording& recording, std::string name,
                         std::string title);

/// A part of it.
report::Chart zoom_chart(const carrier_track::Scene& scene,
                         const carrier_track::Recording& recording, const PathZoom& zoom,
                         std::string name);

}  // namespace ricochet::studies
