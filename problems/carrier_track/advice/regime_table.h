#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/regimes/sampled_turns.h"
#include "ricochet/regimes.h"
#include "src/report/json.h"

/// The regimes of a machine as text and data.
namespace ricochet::studies::advice {

/// Without those that are less than 1 % of the speed wide and lie between wider ones: they are one
/// border to the eye.
std::vector<carrier_track::Regime> without_narrow(
    const std::vector<carrier_track::Regime>& regimes);

/// "2", or "1 to 4" where turns differ.
std::string counts_of(const carrier_track::Regime& regime);

/// "silent up to 1.447 rad/s (13.82 rpm), at most 2 collisions a turn up to 8.079 rad/s (77.15
/// rpm), at most 4 collisions a turn beyond": the first few levels; silence and the usual limit
/// always.
std::string summary_of(const std::vector<carrier_track::Regime>& regimes);

/// The table with its header, without narrow regimes; the row that ends at `marked` [rad/s] is
/// marked.
std::string text_of(const std::vector<carrier_track::Regime>& regimes,
                    std::optional<double> marked);

/// All regimes; energies, speeds and shares are those at the fast end.
report::Json json_of(const std::vector<carrier_track::Regime>& regimes);

/// A table, with a sentence on what it is; empty if there is none.
std::string text_of(const std::vector<carrier_track::SampledTurns>& sampled);

report::Json json_of(const std::vector<carrier_track::SampledTurns>& sampled);

}  // namespace ricochet::studies::advice
