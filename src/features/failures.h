#pragma once

#include "src/features/feature.h"

namespace ricochet {

/// With probability 0.05, drawn anew at every call, a function comes to nothing: NaN is its value,
/// and so are all its slopes. Objective and constraints fail each by itself, all residuals
/// together; so does the Hessian of the Lagrangian.
Feature not_a_number();

/// With probability 1e-3 a call throws std::runtime_error, which ends the run: 1000 calls come to
/// their end once in three times. Judged is what was found before.
Feature throwing();

/// Every call computes for 0.1 ms of processor time, of which a budget in seconds takes notice as
/// it would not of sleep. What the solver does stays the same, unless it or its run has a limit of
/// time.
Feature slow();

}  // namespace ricochet
