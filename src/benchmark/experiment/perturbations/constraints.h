#pragma once

#include "src/benchmark/experiment/perturbations/perturbation.h"

namespace ricochet {

/// Every constraint is shown as 0 where it holds, to within constraint_tolerance, and as 1
/// elsewhere, where there is no number, too. Its slopes are 0, the derivative of that wherever it
/// has one; the Hessian of the Lagrangian is that of the objective. For problems with constraints.
Perturbation binary_constraints();

/// The objective is infinite where an inequality that is shown is broken, as of a simulation that
/// breaks down there: its gradient is NaN, all residuals infinite, their Jacobian NaN, and the
/// Hessian of a Lagrangian with an objective NaN. The constraints are shown as they are. Equalities
/// count for nothing here: they hold next to nowhere. For problems with inequalities. (Bounds can
/// be no such constraint: the evaluator asks no problem outside its box.)
Perturbation infinite_where_infeasible();

}  // namespace ricochet
