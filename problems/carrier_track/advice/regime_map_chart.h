#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/regimes/regime_map.h"
#include "src/report/chart.h"

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

}  // namespace ricochet::studies::advice
