#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "tests/carrier_track/models/brute_force.h"

namespace ricochet::carrier_track {

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
inline Accuracy compare(const Scene& scene, const Outcome& outcome, const Outcome& reference) {
  Accuracy accuracy;
  const int expected = collisions(scene, reference);
  accuracy.count_difference = collisions(scene, outcome) - expected;
  accuracy.end_position_error = std::abs(outcome.end.position - reference.end.position);
  const double window = 0.5 * duration_of(scene) / std::max(expected, 1);
  const std::vector<Impact> seen = faster(outcome.impacts, 0.5 * scene.counting_limit);
  const std::vector<Impact> real = faster(reference.impacts, 0.5 * scene.counting_limit);
  auto s = seen.begin();
  auto r = real.begin();
  while (s != seen.end() || r != real.end()) {
    const bool both = s != seen.end() && r != real.end();
    if (both && s->wall == r->wall && std::abs(s->time - r->time) <= window) {
      if (accuracy.missed + accuracy.spurious == 0) {
        ++accuracy.matched;
        accuracy.impact_time_error =
            std::max(accuracy.impact_time_error.value_or(0.0), std::abs(s->time - r->time));
      }
      ++s;
      ++r;
    } else if (r == real.end() || (both && s->time < r->time)) {
      accuracy.spurious += (s++)->speed > scene.counting_limit;
    } else {
      accuracy.missed += (r++)->speed > scene.counting_limit;
    }
  }
  return accuracy;
}

}  // namespace ricochet::carrier_track
