#pragma once

#include "ricochet/solver.h"

namespace ricochet::live {

/// The CMA evolution strategy (mu/mu_w, lambda) for one variable, on the unit box: N. Hansen, "The
/// CMA evolution strategy: a tutorial", arXiv:1604.00772 (2016), figure 6 with the parameters of
/// its table 1 for n = 1, without negative weights. The mean begins at the start, the step at
/// `initial_step` box widths. A point outside the box is moved to its end. It ends when a step is
/// shorter than 1e-6 of the box. The suite has pagmo's, for any number of variables; this one is
/// for where pagmo is not.
Solver cma_es(double initial_step = 0.5);

}  // namespace ricochet::live
