#pragma once

#include "src/benchmark/experiment/perturbations/perturbation.h"

namespace ricochet {

/// Every number shown (values, gradient, Jacobian, residuals, Hessian) is rounded to 6 significant
/// digits, as in a printed table.
Perturbation truncated();

/// Everything is evaluated at the nearest point of a grid of 1001 values for every variable, from
/// the lower end of the box to the upper one, as on a machine whose controls have notches.
/// Derivatives are those of the unquantised functions at that point, not the zeros of a staircase.
/// The point that the solver evaluated is scored, not the grid point.
Perturbation quantised();

}  // namespace ricochet
