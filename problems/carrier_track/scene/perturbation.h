#pragma once

#include "problems/carrier_track/scene/scene.h"

namespace ricochet::carrier_track::inline scene {

/// The largest relative change of a constant in a perturbed scene: of the tenth digit, some million
/// times what rounding does.
inline constexpr double perturbation_size = 1e-9;

/// A valid scene with all its constants changed at once, each by 0.5 to 1 times
/// perturbation_size one way or the other. `stride`, an irrational number within 0..1, makes the
/// pattern of amounts and signs; `sign`, 1 or -1, turns all of them round. The amounts are drawn in
/// the order of the list of fields: one put among others shifts those of the fields after it.
///
/// Zeros stay, and so do the exponent of a contact, the limits of the rule, the window,
/// restitutions of 1 from above, and the contact of a body that starts on a wall. Lengths change by
/// a share of the largest coordinate, angles by a share of a radian or more.
Scene perturbed(Scene scene, double stride, double sign);

}  // namespace ricochet::carrier_track::inline scene
