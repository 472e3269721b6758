#pragma once

#include <vector>

#include "problems/carrier_track/counting/recording.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track {

/// Force [N] of equation (31) on a body, but for contact and friction, straight from the formula.
double force_of_plate(const Scene& scene, double time);

/// A slow reference that shares nothing with the impact model but the scene: long double, fixed
/// steps [s], and within each step a constant force, that of its middle, under which the body moves
/// on parabolas from event to event. Its error falls with the square of the step.
struct BruteForce {
  std::vector<Impact> impacts;
  double position, velocity;
};
BruteForce brute_force(const Scene& scene, double step);

/// The impacts that are faster than a speed [m/s].
inline std::vector<Impact> faster(std::vector<Impact> impacts, double speed) {
  std::erase_if(impacts, [&](const Impact& impact) { return !(impact.speed > speed); });
  return impacts;
}

}  // namespace ricochet::carrier_track
