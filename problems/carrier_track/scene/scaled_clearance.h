#pragma once

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline scene {

/// The scene with its clearance multiplied by a factor > 0. The lower wall stays; the start stays
/// at the same share of the clearance.
template <class Scalar>
BasicScene<Scalar> scaled_clearance(const Scalar& factor, BasicScene<Scalar> scene) {
  scene.wall_upper = scene.wall_lower + factor * (scene.wall_upper - scene.wall_lower);
  scene.start_position = scene.wall_lower + factor * (scene.start_position - scene.wall_lower);
  return scene;
}

}  // namespace ricochet::carrier_track::inline scene
