#pragma once

#include "src/features/feature.h"

namespace ricochet {

/// Every number v of what is told - values, gradient, Jacobian, residuals, Hessian - becomes
/// v + 1e-3 max(1, |v|) xi, with a standard normal xi of its own, drawn anew at every call. So a
/// gradient is the true one with noise of its own, as from a noisy simulation that differentiates
/// itself; it is not the slope of the noise, which has none. What is not finite stays as it is.
Feature noisy();

/// The same, but xi is fixed in x: to ask again does not average it away.
Feature frozen_noise();

/// With probability 0.2, fixed in x, a function is an outlier: its value v becomes
/// v + max(1, |v|) (pi/2) |C| with a standard Cauchy C, and every slope s of it
/// s + max(1, |s|) (pi/2) C with one of its own. All residuals together are one function.
/// Probability and tail are those of the Cauchy noise of COCO's bbob-noisy suite as its code has
/// them (cocoex), where it is not scaled by |v|; here problems have values of any size.
Feature outliers();

}  // namespace ricochet
