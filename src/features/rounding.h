#pragma once

#include "src/features/feature.h"

namespace ricochet {

/// Every number told - values, gradient, Jacobian, residuals, Hessian - is rounded to 6 significant
/// digits, as if it came from a printed table.
Feature truncated();

/// Everything is evaluated at the next point of a grid of 1001 values for every variable, from the
/// lower end of the box to the upper one, as on a machine whose controls have notches. Derivatives
/// are those at that point: a solver gets slopes from one who knows of no notches, and not the
/// zeros of a staircase. Judged is the point asked for.
Feature quantised();

}  // namespace ricochet
