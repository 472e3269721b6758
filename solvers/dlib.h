#pragma once

#include "src/core/solver.h"

namespace ricochet {

/// "dlib-global-search": dlib's search without parameters in the unit cube, which alternates
/// between the highest point of an upper bound, LIPO (Malherbe and Vayatis, ICML 2017, 2314-2323),
/// and a step to the optimum of a quadratic model in a trust region. Takes no constraints. It
/// begins with the start and points uniform in the box, until two values differ. Points without a
/// number count as the worst so far.
///
/// A point takes time in proportion to those before it, and the more of it the more variables there
/// are. So it takes 8 variables at most, ends after 400 points, and looks for the highest point of
/// the bound among 1000 instead of 5000: 1000 evaluations take about a second.
Solver dlib_global_search();

}  // namespace ricochet
