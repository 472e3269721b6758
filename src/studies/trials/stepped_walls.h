#pragma once

#include <optional>

#include "problems/carrier_track/scene/scene.h"
#include "src/studies/trials/ode45.h"

namespace ricochet::studies::trials {

/// Slower than this [m/s] a sliding body meets less than its full friction, mu N tanh(v / v_s): a
/// friction that jumps would hold the steps of any method at nothing.
inline constexpr double sliding_speed = 2e-3;

/// A simulation with more steps than this is not waited for.
inline constexpr int most_ode_steps = 15'000;

/// How many contacts with compliant walls a method sees that integrates straight through them, as
/// whoever gives equation (31) to ode45 does: a contact is seen where a step ends in a wall that
/// was begun outside, and counts if the motion up to the wall, under the force at the beginning of
/// the step, is faster there than the scene's slowest. One that begins and ends within a step is
/// never seen. A count beyond `most` is `most` + 1, and so is that of too many steps, or of a body
/// further behind a wall than the gap is wide.
///
/// `scene` must be valid, of fidelity compliant and constant speed, and have a contact_speed.
int stepped_count(const carrier_track::Scene& scene, const OdeTolerances& tolerances, int most);

}  // namespace ricochet::studies::trials
