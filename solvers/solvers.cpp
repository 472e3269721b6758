#include "solvers/solvers.h"

#include "solvers/ceres.h"
#include "solvers/ceres_least_squares.h"
#include "solvers/continuation.h"
#include "solvers/fireworks/fireworks.h"
#include "solvers/ipopt.h"
#include "solvers/nlopt.h"
#include "solvers/pagmo.h"
#include "solvers/random_search.h"
#include "solvers/scan.h"

namespace ricochet {

std::vector<Solver> all_solvers() {
  std::vector<Solver> solvers = {
      random_search(),
      scan(),
      fireworks("fireworks", {}),
      fireworks("fireworks-as-printed", {.third_branch = ThirdBranch::as_printed}),
      ipopt(),
      continuation(ipopt()),
      ceres_lbfgs(),
      ceres_least_squares(),
      pagmo_cmaes(),
      pagmo_sade(),
  };
  for (Solver& solver : nlopt_solvers()) {
    if (solver.name == "nlopt-slsqp") solvers.push_back(continuation(solver));
    solvers.push_back(std::move(solver));
  }
  return solvers;
}

}  // namespace ricochet
