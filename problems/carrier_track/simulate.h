#pragma once

#include <stdexcept>
#include <type_traits>

#include "problems/carrier_track/compliant_model.h"
#include "problems/carrier_track/impact_model.h"

namespace ricochet::carrier_track {

/// Simulates `scene` (valid, see scene_check.h) at its fidelity and tells `observer` what happens.
/// Only hard walls carry derivatives: throws std::invalid_argument for a dual scene of another
/// fidelity.
template <class Scalar, class SomeObserver>
End<Scalar> simulate(const BasicScene<Scalar>& scene, SomeObserver& observer) {
  if (scene.fidelity == Fidelity::compliant) {
    if constexpr (std::is_same_v<Scalar, double>) {
      if (!scene.profile.empty()) {
        return CompliantModel<ProfileForces<double>>(scene).run(observer);
      }
      return CompliantModel(scene).run(observer);
    } else {
      throw std::invalid_argument("a compliant wall carries no derivatives");
    }
  }
  if (!scene.profile.empty()) {
    return ImpactModel<Scalar, ProfileForces<Scalar>>(scene).run(observer);
  }
  return ImpactModel<Scalar>(scene).run(observer);
}

}  // namespace ricochet::carrier_track
