#pragma once

#include <concepts>
#include <stdexcept>

#include "problems/carrier_track/motion/compliant_model.h"
#include "problems/carrier_track/motion/dual_simulation.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/motion/planar_model.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track::inline models {

/// Simulates `scene` under the forces of a constant speed or of a profile; see simulate().
template <class Forces, class Scalar, class SomeObserver>
End<Scalar> simulate_under(const BasicScene<Scalar>& scene, SomeObserver& observer) {
  if (scene.fidelity == Fidelity::automatic) {
    throw std::invalid_argument("a scene of fidelity auto has no level of the model to simulate");
  }
  if constexpr (Dual<Scalar>) {
    if (scene.fidelity != Fidelity::impact) {
      throw std::invalid_argument("only hard walls in one direction carry derivatives");
    }
    detail::ErasedObserver<Scalar, SomeObserver> erased(observer);
    return simulate_dual<Forces>(scene, erased);
  } else {
    if (scene.fidelity == Fidelity::impact) return ImpactModel<Scalar, Forces>(scene).run(observer);
    if constexpr (std::same_as<Scalar, double>) {
      if (scene.fidelity == Fidelity::compliant) return CompliantModel<Forces>(scene).run(observer);
      return PlanarModel<Forces>(scene).run(observer);
    } else {
      throw std::invalid_argument(
          "only hard walls in one direction have other scalars than double");
    }
  }
}

/// Simulates `scene` (valid, see scene_check.h) at its fidelity and reports its events to
/// `observer`; no stretches if the scalar is dual. Throws std::invalid_argument for fidelity auto,
/// which counting/fidelity_choice.h resolves, and for a dual scene of another fidelity than impact:
/// only impact has derivatives.
template <class Scalar, class SomeObserver>
End<Scalar> simulate(const BasicScene<Scalar>& scene, SomeObserver& observer) {
  if (scene.profile.empty()) return simulate_under<AppliedForces<Scalar>>(scene, observer);
  return simulate_under<ProfileForces<Scalar>>(scene, observer);
}

}  // namespace ricochet::carrier_track::inline models
