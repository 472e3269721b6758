#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "problems/carrier_track/regimes/regime_map.h"
#include "ricochet/machine.h"
#include "src/report/json.h"
#include "src/report/table.h"
#include "src/studies/machine/charts.h"

/// The regimes of a machine as tables, text and data.
namespace ricochet::studies::advice {

/// Without those that are less than 1 % of the speed wide and lie between wider ones: they are one
/// border to the eye.
std::vector<carrier_track::Regime> without_narrow(
    const std::vector<carrier_track::Regime>& regimes);

/// "2", or "1 to 4" where turns differ.
std::string counts_of(const carrier_track::Regime& regime);

/// "silent up to 1.447 rad/s (13.82 rpm), at most 2 collisions a turn up to 8.079 rad/s (77.15
/// rpm), more beyond".
std::string summary_of(const std::vector<carrier_track::Regime>& regimes);

/// A row for each regime; energies, speeds and shares are those at the fast end.
Table regime_table(const std::vector<carrier_track::Regime>& regimes);

/// The columns of it that a person needs, without narrow regimes.
Table shown_regimes(const std::vector<carrier_track::Regime>& regimes);

Table sampled_table(const std::vector<carrier_track::SampledTurns>& sampled);

/// That table, with a sentence on what it is; empty if it is.
std::string text_of(const std::vector<carrier_track::SampledTurns>& sampled);

// The borders of a machine over a constant.

/// A row for each curve, with its heights at a few values of the constant; and why a border of
/// the machine goes no farther. Borders less than 1 % of the speed apart are one.
std::string text_of(const carrier_track::RegimeMap& map, const MapUnits& units);

/// All points of all curves, and all cells, in SI units.
report::Json json_of(const carrier_track::RegimeMap& map);

/// A row for each point of the curves.
Table point_table(const carrier_track::RegimeMap& map);

}  // namespace ricochet::studies::advice
