#pragma once

#include "src/core/solver.h"

namespace ricochet {

/// Golden-section search (Kiefer 1953, doi 10.2307/2032161) for one variable without constraints:
/// keeps an interval with a point between that is no worse than its ends, and tries the golden
/// section of its longer part. It begins with the box and the start between.
Solver golden_section();

}  // namespace ricochet
