#pragma once

#include <cmath>

#include "ricochet/scene.h"

/// The restitution of a wall, with the loss by contact friction.
namespace ricochet::carrier_track::inline scene {

/// The factor by which contact friction reduces a wall's restitution, see BasicScene.
template <class Scalar>
Scalar returned_share(const BasicScene<Scalar>& scene) {
  using std::sqrt;
  const Scalar one = constant<Scalar>(1.0);
  if (!scene.contact_friction) return one;
  // The derivative with respect to this friction is infinite; it is set to 0.
  if (value(scene.friction) >= 1) return constant<Scalar>(0.0);
  return sqrt((one - scene.friction) / (one + scene.friction));
}

template <class Scalar>
Scalar lower_restitution(const BasicScene<Scalar>& scene) {
  return scene.restitution_lower * returned_share(scene);
}

template <class Scalar>
Scalar upper_restitution(const BasicScene<Scalar>& scene) {
  return scene.restitution_upper * returned_share(scene);
}

}  // namespace ricochet::carrier_track::inline scene
