#pragma once

#include "ricochet/solver.h"

namespace ricochet {

/// Golden-section search (Kiefer 1953, doi 10.2307/2032161) for one variable without constraints:
/// keeps an interval and a point inside it that is no worse than the ends, and tries the golden
/// section of the longer part. The first interval is the box, the first inner point the start.
Solver golden_section();

}  // namespace ricochet
