#pragma once

#include <stdexcept>
#include <type_traits>

#include "problems/carrier_track/compliant_model.h"
#include "problems/carrier_track/impact_model.h"
#include "problems/carrier_track/level.h"
#include "problems/carrier_track/planar_model.h"

namespace ricochet::carrier_track {

/// Simulates `scene` (valid, see scene_check.h) at its fidelity and tells `observer` what happens.
/// Only hard walls in one direction carry derivatives: throws std::invalid_argument for a dual
/// scene of another fidelity.
template <class Scalar, class SomeObserver>
End<Scalar> simulate(const BasicScene<Scalar>& scene, SomeObserver& observer) {
  const bool steady = scene.profile.empty();
  if (scene.fidelity == Fidelity::impact) {
    if (steady) return ImpactModel<Scalar>(scene).run(observer);
    return ImpactModel<Scalar, ProfileForces<Scalar>>(scene).run(observer);
  }
  if constexpr (std::is_same_v<Scalar, double>) {
    if (scene.fidelity == Fidelity::automatic) return simulate(settled(scene), observer);
    if (scene.fidelity == Fidelity::compliant) {
      if (steady) return CompliantModel(scene).run(observer);
      return CompliantModel<ProfileForces<double>>(scene).run(observer);
    }
    if (steady) return PlanarModel(scene).run(observer);
    return PlanarModel<ProfileForces<double>>(scene).run(observer);
  }
  throw std::invalid_argument("only hard walls in one direction carry derivatives");
}

}  // namespace ricochet::carrier_track
