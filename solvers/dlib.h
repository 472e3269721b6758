#pragma once

#include "ricochet/solver.h"

namespace ricochet {

/// "dlib-global-search": dlib's search without parameters in the unit cube. It alternates between
/// the highest point of an upper bound, LIPO (Malherbe and Vayatis, ICML 2017, 2314-2323), and a
/// step to the optimum of a quadratic model in a trust region. It begins with the start and points
/// uniform in the box, until two values differ. Points without a finite value count as the worst so
/// far.
///
/// The time for a point grows in proportion to the number of points before it, and with the number
/// of variables. So the solver takes at most 8 variables, ends after 400 points, and looks for the
/// highest point of the bound among 1000 points instead of 5000: 1000 evaluations take about a
/// second.
Solver dlib_global_search();
inline constexpr Capabilities dlib_capabilities = {.most_variables = 8};

}  // namespace ricochet
