#pragma once

#include <string>
#include <vector>

#include "ricochet/regimes.h"
#include "src/report/json.h"

/// The regimes of a machine as text and data.
namespace ricochet::studies::advice {

/// A row of the table: a regime, or several narrow ones that follow each other and are one border
/// to the eye.
struct RegimeRow {
  carrier_track::Regime regime;  ///< from the first, to the last; counts over all
  int merged = 1;                ///< number of regimes
};

/// The rows: regimes less than 1 % of the speed wide are merged with their narrow neighbours.
std::vector<RegimeRow> rows_of(const std::vector<carrier_track::Regime>& regimes);

/// "silent up to 1.447 rad/s (13.82 rpm), then 2 collisions a turn up to 8.079 rad/s (77.15 rpm),
/// then 4": the first few wide regimes.
std::string summary_of(const std::vector<carrier_track::Regime>& regimes);

/// The table with its header; the row that ends at `marked` [rad/s] is marked.
std::string text_of(const std::vector<carrier_track::Regime>& regimes,
                    std::optional<double> marked);

/// All regimes; energies, speeds and shares are those at the fast end.
report::Json json_of(const std::vector<carrier_track::Regime>& regimes);

}  // namespace ricochet::studies::advice
