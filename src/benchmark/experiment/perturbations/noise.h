#pragma once

#include "src/benchmark/experiment/perturbations/perturbation.h"

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

}  // namespace ricochet
