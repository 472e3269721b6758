#pragma once

#include "ricochet/scene.h"

namespace ricochet::carrier_track {

/// The constants that an exploratory study fitted to the paper ("starting
/// interpretation"): a lively scene that stays the same when the default interpretation is fitted
/// again.
inline Scene exploratory_scene() {
  Scene scene;
  scene.mass = 1.2;
  scene.wall_upper = 1.04e-3;
  scene.normal_force = 1.670;
  scene.pull = 0.888;
  scene.centrifugal_mass_radius = 0.2043;
  scene.phase = 3.12;
  scene.start_position = 0.54 * 1.04e-3;
  scene.start_velocity = -0.090;
  scene.omega = 3.0;
  scene.window = Revolutions{1.314};
  scene.counting_limit = 9.65e-3;
  return scene;
}

}  // namespace ricochet::carrier_track
