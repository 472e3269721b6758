#pragma once

#include <fmt/format.h>

#include <string>

#include "src/report/json.h"
#include "src/studies/machine/charts.h"

namespace ricochet::cli {

/// Prints how far two stores or archives order their entries alike, by family, and which entries
/// changed from the first to the second: see entry_changes().
int compare_stores(const std::string& first, const std::string& second, bool json);

/// The agreement of two orders in words; null if they cannot be compared.
inline std::string agreement_in_words(const report::Json& agreement) {
  if (agreement.is_null()) return "the orders cannot be compared";
  return fmt::format("Kendall's tau {:.2f} [{:.2f}, {:.2f}] over {} entries",
                     agreement["correlation"].get<double>(), agreement["lower"].get<double>(),
                     agreement["upper"].get<double>(), agreement["entries"].get<int>());
}

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
