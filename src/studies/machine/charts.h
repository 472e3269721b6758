#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/regimes/regime_map.h"
#include "ricochet/machine.h"
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

namespace ricochet::studies::advice {

/// The unit in which a constant is shown.
struct ShownUnit {
  std::string name = {};  ///< "mm"; empty for a number without unit
  double size = 1;        ///< in the constant's own unit: 1e-3 for mm
};

/// Machines and speeds to mark in a map.
struct MapMarks {
  struct Value {
    double constant;
    std::string label;  ///< of its entry in the legend
  };
  struct Point {
    double constant;
    double omega;      ///< [rad/s]
    std::string name;  ///< written beside it
  };

  std::vector<Value> machines;    ///< as vertical lines
  std::vector<Point> thresholds;  ///< the paper's
};

/// A map of regimes as a picture: speed upwards, the constant to the right, regions coloured by
/// the most collisions a turn, borders on top.
report::Chart regime_map_chart(const carrier_track::RegimeMap& map, std::string title,
                               const ShownUnit& unit, const MapMarks& marks);

/// The counts over the speeds up to the fastest, sampled where they change.
std::vector<report::Sample> staircase_samples(const carrier_track::QuietSpeed& answer);

/// A speed [rad/s] to mark in a chart of a staircase, if any.
struct MarkedSpeed {
  std::optional<double> omega;
  std::string label;
};

/// The staircase with its steps marked; other marked speeds come first.
report::Chart staircase_chart(const carrier_track::QuietSpeed& answer, std::string title,
                              const std::vector<MarkedSpeed>& marked);

}  // namespace ricochet::studies::advice
