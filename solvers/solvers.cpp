#include "solvers/solvers.h"

#include "solvers/bisection.h"
#include "solvers/ceres.h"
#include "solvers/ceres_least_squares.h"
#include "solvers/continuation.h"
#include "solvers/fireworks/fireworks.h"
#include "solvers/golden_section.h"
#include "solvers/ipopt.h"
#include "solvers/nlopt.h"
#include "solvers/pagmo.h"
#include "solvers/plateau_search/plateau_search.h"
#include "solvers/random_search.h"
#include "solvers/scan.h"

namespace ricochet {

std::vector<Solver> all_solvers() {
  std::vector<Solver> solvers = {
      random_search(),
      scan(),
      bisection(),
      golden_section(),
      fireworks("fireworks", {}),
      fireworks("fireworks-as-printed", {.third_branch = ThirdBranch::as_printed}),
      plateau_search(),
#ifdef RICOCHET_HAS_IPOPT
      ipopt(Settings::own),
      ipopt(Settings::tuned),
      continuation(ipopt(Settings::tuned)),
#endif
#ifdef RICOCHET_HAS_CERES
      ceres_lbfgs(),
      ceres_least_squares(),
#endif
#ifdef RICOCHET_HAS_PAGMO
      pagmo_cmaes(Settings::own),
      pagmo_cmaes(Settings::tuned),
      pagmo_sade(),
#endif
  };
  for (Solver& solver : nlopt_solvers()) {
    if (solver.name == "nlopt-slsqp") solvers.push_back(continuation(solver));
    solvers.push_back(std::move(solver));
  }
  return solvers;
}

std::vector<MissingSolver> missing_solvers() {
  return {
#ifndef RICOCHET_HAS_IPOPT
      {"ipopt", "Ipopt"},
      {"ipopt-tuned", "Ipopt"},
      {"continuation-ipopt-tuned", "Ipopt"},
#endif
#ifndef RICOCHET_HAS_CERES
      {"ceres-lbfgs", "Ceres"},
      {"ceres-trust-region", "Ceres"},
#endif
#ifndef RICOCHET_HAS_PAGMO
      {"pagmo-cmaes", "pagmo"},
      {"pagmo-cmaes-tuned", "pagmo"},
      {"pagmo-sade", "pagmo"},
#endif
  };
}

}  // namespace ricochet
