#pragma once

#include <vector>

#include "src/core/solver.h"

namespace ricochet::fireworks {

/// Every member of the family, as published or, "corrected", as we would have it. "as-printed" is
/// what the third branch of equation (24) comes to in the paper's print.
std::vector<Solver> family();

}  // namespace ricochet::fireworks
