#pragma once

#include <vector>

#include "solvers/adjustable_solver.h"

namespace ricochet::fireworks {

/// The members of the family except fireworks-as-printed. Options: "fireworks"; "sparks" of a
/// generation (of each firework in lotfwa); "gaussian_sparks"; "amplitude" in the member's own
/// unit; "guiding_share"; and "growth" and "decline" of the amplitude from generation to
/// generation.
std::vector<AdjustableSolver> adjustable_family();

}  // namespace ricochet::fireworks
