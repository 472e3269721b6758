#pragma once

#include <stdexcept>
#include <type_traits>

#include "problems/carrier_track/counting/fidelity_choice.h"
#include "problems/carrier_track/models/compliant_model.h"
#include "problems/carrier_track/models/impact_model.h"
#include "problems/carrier_track/models/planar_model.h"

namespace ricochet::carrier_track::inline models {

/// The same for the forces of a constant speed or of a profile, at a level that is not left open.
template <class Forces, class Scalar, class SomeObserver>
End<Scalar> simulate_under(const BasicScene<Scalar>& scene, SomeObserver& observer) {
  if (scene.fidelity == Fidelity::impact) return ImpactModel<Scalar, Forces>(scene).run(observer);
  if constexpr (std::is_same_v<Scalar, double>) {
    if (scene.fidelity == Fidelity::compliant) return CompliantModel<Forces>(scene).run(observer);
    return PlanarModel<Forces>(scene).run(observer);
  }
  throw std::invalid_argument("only hard walls in one direction carry derivatives");
}

/// Simulates `scene` (valid, see scene_check.h) at its fidelity and tells `observer` what happens.
/// Only hard walls in one direction carry derivatives: throws std::invalid_argument for a dual
/// scene of another fidelity.
template <class Scalar, class SomeObserver>
End<Scalar> simulate(const BasicScene<Scalar>& scene, SomeObserver& observer) {
  if constexpr (std::is_same_v<Scalar, double>) {
    if (scene.fidelity == Fidelity::automatic) return simulate(resolve_fidelity(scene), observer);
  }
  if (scene.profile.empty()) return simulate_under<AppliedForces<Scalar>>(scene, observer);
  return simulate_under<ProfileForces<Scalar>>(scene, observer);
}

}  // namespace ricochet::carrier_track::inline models
