#pragma once

#include <cmath>
#include <limits>

namespace ricochet::carrier_track::inline events {

/// Smallest h > 0 with value + slope h - bound h^2 / 2 = 0, for value >= 0; infinite if there is
/// none: no function with this value and slope, whose second derivative is at least -bound, is
/// negative before h.
inline double step_bound(double value, double slope, double bound) {
  const double root = std::sqrt(slope * slope + 2 * bound * value);
  if (slope < 0) return 2 * value / (root - slope);
  return bound > 0 ? (slope + root) / bound : std::numeric_limits<double>::infinity();
}

}  // namespace ricochet::carrier_track::inline events
