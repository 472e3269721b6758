#pragma once

#include <vector>

#include "ricochet/solver.h"

namespace ricochet {

/// Solvers of TAO, the optimisation part of PETSc, each with its library's own settings, over the
/// unit cube: bounded limited-memory variable metric, `tao-blmvm`; bounded quasi-Newton line
/// search, `tao-bqnls`; bounded nonlinear conjugate gradients, `tao-bncg`; for least squares
/// POUNDERS, without derivatives, `tao-pounders`, and bounded regularised Gauss-Newton, `tao-brgn`.
/// Sources: for POUNDERS, Wild, in Advances and Trends in Optimization with Engineering
/// Applications (2017), ch. 40; for all, the TAO Users Manual, ANL/MCS-TM-322 Rev. 3.18 (2022).
///
/// They are in a separate shared library, which the first start of one loads, in 0.1 s; a start
/// throws std::runtime_error if it does not load. Returns none if that library or PETSc is missing.
std::vector<Solver> tao_solvers();
inline constexpr Capabilities tao_gradient_capabilities = {.derivatives =
                                                               Capabilities::Order::gradient};
inline constexpr Capabilities tao_residual_capabilities = {.needs_residuals = true};

}  // namespace ricochet
