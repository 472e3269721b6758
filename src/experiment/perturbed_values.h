#pragma once

#include <cstdint>
#include <functional>

#include "ricochet/problem.h"
#include "src/experiment/perturbations.h"

namespace ricochet {

/// Every number v shown to the solver (values, gradient, Jacobian, residuals, Hessian) becomes v +
/// 1e-3 max(1, |v|) xi, with an independent standard normal xi at every call. So a gradient is the
/// true one plus independent noise, as from a noisy simulation that differentiates itself; it is
/// not the slope of the noise, which does not exist. Values that are not finite stay unchanged.
Perturbation noisy();

/// The same, but xi is a function of x: repeated evaluations do not average it away.
Perturbation frozen_noise();

/// With probability 0.2, fixed in x, a function is an outlier: its value v becomes v + max(1, |v|)
/// (pi/2) |C| with a standard Cauchy C, and every slope s of it s + max(1, |s|) (pi/2) C with an
/// independent C. All residuals together are one function. Probability and tail are those of the
/// Cauchy noise of COCO's bbob-noisy suite in its code (cocoex); there it is not scaled by |v|, but
/// here problems have values of any size.
Perturbation outliers();

/// With probability 0.05, drawn independently at every call, a function fails: its value and all
/// its slopes are NaN. The objective and each constraint fail separately, all residuals together;
/// the Hessian of the Lagrangian fails in the same way.
Perturbation not_a_number();

/// With probability 1e-3 a call throws std::runtime_error, which ends the run: about one run in
/// three gets through 1000 calls. Points found before count.
Perturbation throwing();

/// Every call takes 0.1 ms of processor time, which counts against a budget in seconds (sleep would
/// not). The solver's results stay the same, unless it or its run has a time limit.
Perturbation slow();

/// Every number shown (values, gradient, Jacobian, residuals, Hessian) is rounded to 6 significant
/// digits, as in a printed table.
Perturbation truncated();

/// Everything is evaluated at the nearest point of a grid of 1001 values for every variable, from
/// the lower end of the box to the upper one, as on a machine whose controls have notches.
/// Derivatives are those of the unquantised functions at that point, not the zeros of a staircase.
/// The point that the solver evaluated is scored, not the grid point.
Perturbation quantised();

/// Whether a draw depends on the number of calls so far, or on x only, so that repeated evaluations
/// give the same result.
enum class Drawn { by_call, by_point };

/// Changes one function as shown: its values, and as many rows of slopes, or none if slopes were
/// not requested. Must draw for the values before it draws for the slopes.
using Tell =
    std::function<void(Eigen::Ref<Vector> values, Eigen::Ref<Matrix> slopes, Draws& draws)>;

/// The problem with everything it shows a solver changed by `tell`. Objective and gradient are
/// changed together, so are every constraint and its row of the Jacobian, and all residuals with
/// their Jacobian. The Hessian of the Lagrangian, whose multipliers change from call to call, is a
/// function without values; it stays symmetric. Each function has its own draws; its values are the
/// same whether its slopes are requested or not.
Problem told_by(const Tell& tell, Drawn drawn, std::uint64_t key, const Problem& shown);

}  // namespace ricochet
