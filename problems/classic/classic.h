#pragma once

#include <vector>

#include "ricochet/problem.h"

/// Problems from the literature with known optima: results are comparable with published ones.
namespace ricochet::classic {

/// Test functions, "classic-...", and test problems of Hock and Schittkowski, "hs-...".
std::vector<Problem> classic_problems();

}  // namespace ricochet::classic
