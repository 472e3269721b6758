#pragma once

#include "src/benchmark/experiment/perturbations/perturbation.h"

namespace ricochet {

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

}  // namespace ricochet
