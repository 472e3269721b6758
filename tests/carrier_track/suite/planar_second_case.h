#pragma once

#include "problems/carrier_track/scene/contact_law.h"
#include "problems/carrier_track/suite/machine.h"

namespace ricochet::carrier_track {

/// The second case in the planar model, which has no regimes: nothing couples its directions.
inline Scene planar_second_case() {
  Scene scene = scene_of(find_case("C2"), default_machine());
  scene.restitution_lower = scene.restitution_upper = lower_restitution(scene);
  scene.contact_friction = false;
  scene.across.emplace();
  scene.fidelity = Fidelity::planar;
  return scene;
}

}  // namespace ricochet::carrier_track
