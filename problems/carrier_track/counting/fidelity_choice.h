#pragma once

#include <type_traits>

#include "problems/carrier_track/models/simulate.h"
#include "ricochet/recording.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline counting {

/// Returns true if the second direction of a scene can affect the first: the carrier may move in y,
/// or be pressed to a wall there, and friction couples the directions. If not, x is the same
/// without y.
bool couples(const Scene& scene);

/// The cheapest level whose count is certain for a valid scene. Fidelity auto selects it:
///   planar, if the scene has a second direction that couples;
///   else impact, if its count is certain;
///   else compliant, if its count is certain, with the scene's contact law and stiffness;
///   else impact: no level makes this count certain.
/// Costs up to ten simulations.
Fidelity needed_fidelity(const Scene& scene);

/// The scene with fidelity auto replaced by the needed level.
Scene resolve_fidelity(const Scene& scene);

/// simulate() for a scene that may have fidelity auto. The level is chosen for this scene, so it
/// may differ from one speed to the next.
template <class Scalar, class SomeObserver>
End<Scalar> simulate_at_needed_fidelity(const BasicScene<Scalar>& scene, SomeObserver& observer) {
  if constexpr (std::is_same_v<Scalar, double>) {
    if (scene.fidelity == Fidelity::automatic) return simulate(resolve_fidelity(scene), observer);
  }
  return simulate(scene, observer);
}

}  // namespace ricochet::carrier_track::inline counting
