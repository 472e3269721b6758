#pragma once

#include <string>

#include "problems/carrier_track/advice/regime_map_chart.h"
#include "problems/carrier_track/regimes/regime_map.h"
#include "src/report/json.h"

/// The borders of a machine over a constant, as text and data.
namespace ricochet::studies::advice {

/// A row for each border of the machine itself, with its speed at a few values of the constant; and
/// where a border ends. Borders less than 1 % of the speed apart are one.
std::string text_of(const carrier_track::RegimeMap& map, const ShownUnit& unit);

/// All points of all borders, in SI units.
report::Json json_of(const carrier_track::RegimeMap& map);

/// The same as a table, with a header: a line for each point.
std::string csv_of(const carrier_track::RegimeMap& map);

}  // namespace ricochet::studies::advice
