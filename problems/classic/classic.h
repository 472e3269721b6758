#pragma once

#include <vector>

#include "src/core/problem.h"

/// Problems from the literature, with known optima: what a solver does there is comparable with
/// what others do.
namespace ricochet::classic {

/// Test functions, "classic-...", and test problems of Hock and Schittkowski, "hs-...".
std::vector<Problem> classic_problems();

}  // namespace ricochet::classic
