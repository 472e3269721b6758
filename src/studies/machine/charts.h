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

/// The name of the counted events of a path: "impact that counts" or "maximum that counts".
std::string counted_label(const carrier_track::Scene& scene);

/// x [mm] along a recorded path, with its counted events, and the walls.
report::Chart path_chart(const carrier_track::Scene& scene,
                         const carrier_track::Recording& recording, std::string name,
                         std::string title);

/// The part of the path with most of the counted events, sampled finely: the chart "zoom". Empty if
/// no small part of the path has most of them. Simulates again.
std::optional<report::Chart> zoom_chart(const carrier_track::Scene& scene,
                                        const carrier_track::Recording& recording);

}  // namespace ricochet::studies

namespace ricochet::studies::advice {

/// The unit in which a constant is shown.
struct ShownUnit {
  std::string name = {};  ///< "mm"; empty for a number without unit
  double size = 1;        ///< in the constant's own unit: 1e-3 for mm
};

/// The units of both axes of a map.
struct MapUnits {
  ShownUnit over = {};
  ShownUnit against = {"rad/s"};
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

/// A map as a picture: cells coloured by their collisions a turn, followed borders on top.
report::Chart regime_map_chart(const carrier_track::RegimeMap& map, std::string title,
                               const MapUnits& units, const MapMarks& marks);

/// A speed [rad/s] to mark in a chart of a staircase, if any.
struct MarkedSpeed {
  std::optional<double> omega;
  std::string label;
};

/// The counts over the speeds up to the fastest, with their steps marked; other marked speeds come
/// first.
report::Chart staircase_chart(const carrier_track::QuietSpeed& answer, std::string title,
                              const std::vector<MarkedSpeed>& marked);

}  // namespace ricochet::studies::advice
