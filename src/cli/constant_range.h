#pragma once

#include <string>

#include "problems/carrier_track/advice/regime_map_chart.h"

namespace ricochet::cli {

/// A range of a constant of a scene: "restitution=0.05..0.95", "clearance=0.5 mm..2 mm",
/// "clearance=0.5..2 mm".
struct ConstantRange {
  std::string constant;
  double from, to;                    ///< in SI units
  studies::advice::ShownUnit unit{};  ///< of the range's end
};

/// Throws InputError, which names --over, for a text that is no such range or has an unknown
/// constant or unit.
ConstantRange constant_range_of(const std::string& text);

}  // namespace ricochet::cli
