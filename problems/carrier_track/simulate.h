#pragma once

#include <stdexcept>
#include <type_traits>

#include "problems/carrier_track/compliant_model.h"
#include "problems/carrier_track/impact_model.h"
#include "problems/carrier_track/planar_model.h"

namespace ricochet::carrier_track {

/// Simulates `scene` (valid, see scene_check.h) at its fidelity and tells `observer` what happens.
/// Only hard walls in one direction carry derivatives: throws std::invalid_argument for a dual
/// scene of another fidelity.
template <class Scalar, class SomeObserver>
End<Scalar> simulate(const BasicScene<Scalar>& scene, SomeObserver& observer) {
  if (scene.fidelity == Fidelity::compliant) {
    if constexpr (std::is_same_v<Scalar, double>) {
      return CompliantModel(scene).run(observer);
    } else {
      throw std::invalid_argument("a compliant wall carries no derivatives");
    }
  }
  if (scene.fidelity == Fidelity::planar) {
    if constexpr (std::is_same_v<Scalar, double>) {
      return PlanarModel(scene).run(observer);
    } else {
      throw std::invalid_argument("a motion in two directions carries no derivatives");
    }
  }
  return ImpactModel<Scalar>(scene).run(observer);
}

}  // namespace ricochet::carrier_track
