#pragma once

#include "problems/carrier_track/scene/scene.h"

namespace ricochet::carrier_track::inline counting {

/// Whether the second direction of a scene can act on the first: the carrier may move in y, or be
/// pressed to a wall there, and friction hands it on. If not, x is the same without y.
bool couples(const Scene& scene);

/// The cheapest level whose count is certain for a valid scene, which is what fidelity auto means:
///   planar, if the scene has a second direction that couples;
///   else impact, if its count is certain;
///   else compliant, if its count is certain, with the scene's contact law and stiffness;
///   else impact: no level makes this count certain.
/// Costs up to ten simulations.
Fidelity needed_fidelity(const Scene& scene);

/// The scene at its needed level, where it leaves that open.
Scene resolve_fidelity(const Scene& scene);

}  // namespace ricochet::carrier_track::inline counting
