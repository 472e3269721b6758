#pragma once

#include <vector>

#include "solvers/adjustable_solver.h"

namespace ricochet::fireworks {

/// The members of the family except fireworks-as-printed. Options: "fireworks"; "sparks" of a
/// generation (of each firework in lotfwa, mgfwa and fwassp); "gaussian_sparks"; "amplitude" in the
/// member's own unit; "guiding_share" and "guiding_sparks"; "growth" and "decline" of the amplitude
/// from generation to generation; and "initial_scale" in box widths and "patience" of fwassp.
std::vector<AdjustableSolver> adjustable_family();

}  // namespace ricochet::fireworks
