#pragma once

#include <optional>

namespace ricochet::carrier_track::inline counting {

/// The two speeds [rad/s] at which a published figure shows x(t).
struct Figure {
  int number;
  double quiet, loud;
};

/// Published values of a machine, for comparison; without value if not published.
struct Claim {
  std::optional<double> threshold;  ///< [rad/s]
  std::optional<int> quiet_count;   ///< the count below the threshold
  std::optional<Figure> figure;
};

}  // namespace ricochet::carrier_track::inline counting
