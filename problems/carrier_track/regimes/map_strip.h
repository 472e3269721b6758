#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/regimes/regime_map.h"

/// What lies between two neighbouring columns of a map of regimes.
namespace ricochet::carrier_track::inline regimes {

/// Points of a followed border are this many between two columns, and the second column's.
inline constexpr std::size_t strip_parts = 4;

/// A border that was followed through a strip, or as far as it leads.
struct StripLink {
  /// The border's place in a column: of the regime that it ends. Missing where the curve is beyond
  /// the range of speeds, or ends.
  std::optional<std::size_t> left, right;
  /// By rising constant; strip_parts + 1 at even distances if it leads through the strip.
  std::vector<MapPoint> points;
  CurveEnd end = CurveEnd::range;  ///< why it ends within the strip

  bool leads_through() const { return points.size() == strip_parts + 1; }
};

/// The borders between two columns. `followed`: by continuation, unless a motion of a column does
/// not repeat; else by their kind and counts.
std::vector<StripLink> strip_links(const MapColumn& left, const MapColumn& right,
                                   const RegimeMapOptions& options, bool followed);

/// The regions between two columns, each as long as the strip or half of it, and whether all are as
/// long as the strip.
struct StripRegions {
  std::vector<MapRegion> regions;
  bool whole = true;
};
StripRegions strip_regions(const MapColumn& left, const MapColumn& right,
                           const std::vector<StripLink>& links, const RegimeMapOptions& options);

}  // namespace ricochet::carrier_track::inline regimes
