#pragma once

#include "solvers/settings.h"
#include "src/core/solver.h"

namespace ricochet {

/// "pagmo-cmaes": the evolution strategy with covariance matrix adaptation (Hansen, in: Towards a
/// New Evolutionary Computation, 2006, 75-102; doi 10.1007/3-540-32494-1_4) of pagmo in the unit
/// cube, with 4 + floor(3 ln n) points a generation, at least 5. Takes no constraints. Ends where a
/// step is below 1e-8 of the box, or where all points of a generation are worth the same.
Solver pagmo_cmaes(Settings settings);

/// "pagmo-sade": differential evolution that adapts its weight and crossover rate itself, jDE
/// (Brest et al., IEEE Trans. Evol. Comput. 10 (2006) 646-657; doi 10.1109/TEVC.2006.872133), of
/// pagmo in the unit cube, with mutation rand/1/exp, pagmo's default, of 10 n points, but 20 at
/// least and 100 at most. Takes no constraints. Ends as pagmo_cmaes() does, but looks at the step
/// from the best point to the worst.
Solver pagmo_sade();

}  // namespace ricochet
