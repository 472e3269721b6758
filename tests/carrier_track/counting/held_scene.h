#pragma once

#include "ricochet/scene.h"

namespace ricochet::carrier_track {

/// A carrier that friction holds until the centrifugal force beats it, at the square root of
/// friction normal_force / centrifugal_mass_radius.
inline Scene held() {
  Scene scene;
  scene.start_position = 0.5;
  scene.restitution_lower = scene.restitution_upper = 0;
  scene.friction = 0.2;
  scene.normal_force = 500;
  scene.centrifugal = Centrifugal::outward;
  scene.centrifugal_mass_radius = 1;
  scene.window = Seconds{10};
  return scene;
}

}  // namespace ricochet::carrier_track
