#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace ricochet::carrier_track::inline scene {

/// The units in which a text may give a number whose SI unit is `unit`: "m", "cm", "mm" for "m".
/// Empty for a number without a unit, and for units that depend on other numbers.
std::vector<std::string_view> units_for(std::string_view unit);

/// The number [unit] that a text gives: a number and one of units_for(unit), with or without a
/// blank between. "0.8 mm" is
/// 0.0008 for "m". Returns nothing for any other text.
std::optional<double> quantity(std::string_view text, std::string_view unit);

}  // namespace ricochet::carrier_track::inline scene
