#include "problems/carrier_track/integrators/forces.h"

#include <algorithm>
#include <numbers>

#include "problems/carrier_track/scene.h"

namespace ricochet::carrier_track {

double Forces::shortest_period() const {
  const double fastest =
      std::max(turning != 0 ? omega : 0.0, disturbance != 0 ? disturbance_frequency : 0.0);
  return 2 * std::numbers::pi / fastest;
}

Forces forces_of(const Scene& scene) {
  Forces forces;
  const double square = scene.omega * scene.omega;
  const double centrifugal = scene.centrifugal_mass_radius * square / scene.mass;
  const double pull = scene.pull / scene.mass;
  forces.turning = -scene.slider_mass_radius * square / scene.mass;
  (scene.pull_rotates ? forces.turning : forces.steady) -= pull;
  if (scene.centrifugal == Centrifugal::projected) forces.turning += centrifugal;
  if (scene.centrifugal == Centrifugal::inward) forces.steady -= centrifugal;
  if (scene.centrifugal == Centrifugal::outward) forces.steady += centrifugal;
  forces.omega = scene.omega;
  forces.phase = scene.phase;
  forces.disturbance = scene.disturbance / scene.mass;
  forces.disturbance_frequency = scene.disturbance_frequency;
  forces.friction = scene.friction * scene.normal_force / scene.mass;
  return forces;
}

}  // namespace ricochet::carrier_track
