#pragma once

#include <optional>

#include "problems/carrier_track/reference_integrators/integrator.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// How far an outcome is from a reference of the same scene.
///
/// An impact is fast if the scene counts it: its speed is above `slowest`. Fast impacts are matched
/// in order: the next two of both lists are partners if they are on the same wall and no further
/// apart than half the mean time between the reference's fast impacts; otherwise the earlier one
/// has no partner. So that an impact next to the limit is not lost for being a little slower,
/// a partner needs only half that speed.
struct Accuracy {
  int missed = 0;    ///< fast impacts of the reference without a partner
  int spurious = 0;  ///< fast impacts of the outcome without a partner
  int matched = 0;   ///< pairs before the paths part, which is at the first impact counted above
  /// Largest difference of the times of those pairs [s]; nothing without a pair.
  std::optional<double> impact_time_error;
  int count_difference = 0;       ///< fast impacts of the outcome minus those of the reference
  double end_position_error = 0;  ///< [m], at the end of the window
};

/// `outcome` and `reference` are finished runs of the valid `scene`. The rule `impacts` is applied
/// whatever the scene's rule: outcomes do not tell peaks.
Accuracy compare(const Scene& scene, const Outcome& outcome, const Outcome& reference);

/// How many impacts of `outcome` the scene's limit `slowest` makes count.
int collisions(const Scene& scene, const Outcome& outcome);

}  // namespace ricochet::carrier_track::inline reference_integrators
