#pragma once

#include <stdexcept>
#include <type_traits>

#include "problems/carrier_track/models/compliant_model.h"
#include "problems/carrier_track/models/impact_model.h"
#include "problems/carrier_track/models/planar_model.h"

namespace ricochet::carrier_track::inline models {

/// The same for the forces of a constant speed or of a profile.
template <class Forces, class Scalar, class SomeObserver>
End<Scalar> simulate_under(const BasicScene<Scalar>& scene, SomeObserver& observer) {
  if (scene.fidelity == Fidelity::impact) return ImpactModel<Scalar, Forces>(scene).run(observer);
  if (scene.fidelity == Fidelity::automatic) {
    throw std::invalid_argument("a scene of fidelity auto has no level of the model to simulate");
  }
  if constexpr (std::is_same_v<Scalar, double>) {
    if (scene.fidelity == Fidelity::compliant) return CompliantModel<Forces>(scene).run(observer);
    return PlanarModel<Forces>(scene).run(observer);
  }
  throw std::invalid_argument("only hard walls in one direction carry derivatives");
}

/// Simulates `scene` (valid, see scene_check.h) at its fidelity and tells `observer` what happens.
/// Throws std::invalid_argument for fidelity auto, which counting/fidelity_choice.h resolves, and
/// for a dual scene of another fidelity than impact: only that carries derivatives.
template <class Scalar, class SomeObserver>
End<Scalar> simulate(const BasicScene<Scalar>& scene, SomeObserver& observer) {
  if (scene.profile.empty()) return simulate_under<AppliedForces<Scalar>>(scene, observer);
  return simulate_under<ProfileForces<Scalar>>(scene, observer);
}

}  // namespace ricochet::carrier_track::inline models
