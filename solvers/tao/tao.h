#pragma once

#include <vector>

#include "src/core/solver.h"

namespace ricochet {

/// Solvers of TAO, the optimisation part of PETSc, each with its library's own settings, over the
/// unit cube: bounded limited-memory variable metric, `tao-blmvm`; bounded quasi-Newton line
/// search, `tao-bqnls`; bounded nonlinear conjugate gradients, `tao-bncg`; for least squares
/// POUNDERS, without derivatives, `tao-pounders`, and bounded regularised Gauss-Newton, `tao-brgn`.
/// Wild, in Advances and Trends in Optimization with Engineering Applications (2017), ch. 40, is of
/// POUNDERS; the TAO Users Manual, ANL/MCS-TM-322 Rev. 3.18 (2022), of all.
///
/// They are in a shared library of their own, which the first start of one loads, in 0.1 s; a start
/// throws std::runtime_error where it does not load. None where that library, or PETSc, is missing.
std::vector<Solver> tao_solvers();

}  // namespace ricochet
