#pragma once

#include <optional>

#include "problems/carrier_track/check/reference_integrators/integrator.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// The errors of an outcome relative to a reference for the same scene.
///
/// An impact is fast if the scene counts it: its speed is above `counting_limit`. Fast impacts are
/// matched in order: the next two of both lists are partners if they are on the same wall and no
/// further apart than half the mean time between the reference's fast impacts; otherwise the
/// earlier one has no partner. A partner needs only half that speed, so that an impact just above
/// the limit still has one that is slightly slower.
struct Accuracy {
  int missed = 0;    ///< fast impacts of the reference without a partner
  int spurious = 0;  ///< fast impacts of the outcome without a partner
  int matched = 0;   ///< pairs before the paths diverge, at the first impact counted above
  /// Largest difference of the times of those pairs [s]; empty without a pair.
  std::optional<double> impact_time_error;
  int count_difference = 0;       ///< fast impacts of the outcome minus those of the reference
  double end_position_error = 0;  ///< [m], at the end of the window
};

/// `outcome` and `reference` are finished runs of the valid `scene`. The rule `impacts` is applied
/// whatever the scene's rule: outcomes contain no peaks.
Accuracy compare(const Scene& scene, const Outcome& outcome, const Outcome& reference);

/// The number of impacts of `outcome` above the scene's `counting_limit`.
int collisions(const Scene& scene, const Outcome& outcome);

}  // namespace ricochet::carrier_track::inline reference_integrators
