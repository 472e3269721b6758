#pragma once

#include <optional>
#include <string>

#include "problems/carrier_track/counting/feature_trace.h"
#include "problems/carrier_track/counting/neighbours.h"
#include "ricochet/recording.h"

/// Tests whether a count is certain. A scene's constants are known to a few digits only, and a
/// simulation rounds. So the scene is simulated again with all constants changed at once in their
/// tenth digit (perturbation.h), and the features of the motion (collisions.h) are compared one by
/// one. A count is certain if such a change makes no feature start or stop to count. A count is not
/// certain if infinitely many maxima count, if the change makes the walls cross, or if numbers
/// overflow.
namespace ricochet::carrier_track::inline counting {

/// Returns the certainty of the count of a valid scene from its `trace` and `neighbours`. Simulates
/// the neighbours if they are needed and not simulated yet.
Certainty certainty_of(const Scene& scene, const FeatureTrace& trace, Neighbours& neighbours);

}  // namespace ricochet::carrier_track::inline counting
