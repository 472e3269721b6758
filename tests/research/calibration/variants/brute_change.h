#pragma once

#include <functional>
#include <vector>

#include "problems/carrier_track/counting/recording.h"
#include "ricochet/recording.h"
#include "ricochet/scene.h"

namespace ricochet::studies::variants {

/// What may be changed about a scene, as plain functions.
struct BruteChanges {
  std::function<double(double time)> further_force;  ///< [N]
  std::function<double(double time)> normal_force;   ///< [N]
  std::function<double(double speed, double restitution)> restitution;
};

/// A slow reference that shares nothing with ChangedMotion: fixed steps [s], each under the force
/// and the friction of its middle, on parabolas from event to event in long double.
std::vector<carrier_track::Impact> brute_change(const carrier_track::Scene& scene,
                                                const BruteChanges& changes, double step);

}  // namespace ricochet::studies::variants
