#pragma once

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline scene {

/// The largest relative change of a constant in a perturbed scene, in the tenth digit: about a
/// million times the rounding error.
inline constexpr double perturbation_size = 1e-9;

/// A valid scene with all its constants changed at once, each up or down by 0.5 to 1 times
/// perturbation_size. `stride`, an irrational number within 0..1, sets the pattern of amounts and
/// signs; `sign`, 1 or -1, multiplies all changes. The amounts are drawn in the order of the list
/// of fields, so a new field in the list changes the amounts of all later fields.
///
/// Unchanged are zeros, the exponent of a contact, the limits of the rule and the window. A
/// restitution never rises above 1, and a body that starts on a wall still does. Lengths change by
/// a share of the largest coordinate, angles by a share of the angle or of one radian, whichever is
/// larger.
Scene perturbed(Scene scene, double stride, double sign);

}  // namespace ricochet::carrier_track::inline scene
