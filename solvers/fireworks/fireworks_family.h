#pragma once

#include <vector>

#include "ricochet/solver.h"

namespace ricochet::fireworks {

/// Every member of the family, as published or, for "corrected", with the known defects removed.
/// "as-printed" follows the third branch of equation (24) as the paper prints it.
std::vector<Solver> family();

}  // namespace ricochet::fireworks
