#pragma once

#include <optional>

#include "ricochet/scene.h"
#include "src/research/calibration/variants/ode45.h"

namespace ricochet::studies::variants {

/// A sliding body slower than this [m/s] has less than its full friction, mu N tanh(v / v_s):
/// discontinuous friction would reduce the steps of any method to nothing.
inline constexpr double sliding_speed = 2e-3;

/// A simulation with more steps than this is given up.
inline constexpr int most_ode_steps = 15'000;

/// Counts the contacts with compliant walls that a method without event location detects, as with
/// equation (31) in ode45: a contact is detected if a step begins outside a wall and ends in it,
/// and counts if the motion up to the wall, under the force at the beginning of the step, is faster
/// there than the scene's counting limit. A contact that begins and ends within a step is never
/// detected. A count beyond `most` is `most` + 1, and so is that of too many steps, or of a body
/// further behind a wall than the gap is wide.
///
/// `scene` must be valid, of fidelity compliant and constant speed, and have a contact_speed.
int stepped_count(const carrier_track::Scene& scene, const OdeTolerances& tolerances, int most);

}  // namespace ricochet::studies::variants
