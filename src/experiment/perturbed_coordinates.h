#pragma once

#include "src/experiment/perturbations.h"

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

/// The variables, with their names, are permuted by a random cyclic permutation: no variable keeps
/// its place, and all such permutations are equally likely (Sattolo, Information Processing Letters
/// 22 (1986) 315, doi 10.1016/0020-0190(86)90073-6). For two variables or more.
Perturbation permuted();

/// Each variable is replaced by its negative with probability 1/2, and at least one is. The values
/// of the problem keep every bit.
Perturbation reflected();

/// The problem is rotated about its best point by a uniformly random orthogonal matrix. The box
/// stays the same, except that it grows if needed to contain the start; the variables are mixed now
/// and have no names. For problems that may be rotated, see Problem::rotates, with two variables or
/// more.
Perturbation rotated();

}  // namespace ricochet
