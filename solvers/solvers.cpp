#include "solvers/solvers.h"

#include "solvers/bisection.h"
#include "solvers/ceres.h"
#include "solvers/ceres_least_squares.h"
#include "solvers/continuation.h"
#include "solvers/dlib.h"
#include "solvers/fireworks/fireworks_family.h"
#include "solvers/golden_section.h"
#include "solvers/ipopt.h"
#include "solvers/mads/mads.h"
#include "solvers/nlopt/nlopt.h"
#include "solvers/pagmo/pagmo.h"
#include "solvers/random_search.h"
#include "solvers/scan.h"
#include "solvers/tao/tao.h"

namespace ricochet {

std::vector<Solver> all_solvers() {
  std::vector<Solver> solvers = {
      random_search(),
      scan(),
      bisection(),
      golden_section(),
      mads(),
#ifdef RICOCHET_HAS_IPOPT
      ipopt(Settings::own),
      ipopt(Settings::tuned),
      ipopt_exact(),
      continuation(ipopt(Settings::tuned)),
#endif
#ifdef RICOCHET_HAS_CERES
      ceres_lbfgs(),
      ceres_least_squares(),
#endif
#ifdef RICOCHET_HAS_PAGMO
      pagmo_cmaes(Settings::own),
      pagmo_cmaes(Settings::tuned),
      pagmo_cmaes_ipop(),
      pagmo_xnes(),
      pagmo_de(),
      pagmo_sade(),
      pagmo_de1220(),
      pagmo_gaco(),
      pagmo_compass_search(),
      pagmo_constrained_de(),
#endif
#ifdef RICOCHET_HAS_DLIB
      dlib_global_search(),
#endif
  };
  for (Solver& member : fireworks::family()) solvers.push_back(std::move(member));
  for (Solver& solver : nlopt_solvers()) {
    if (solver.name == "nlopt-slsqp") solvers.push_back(continuation(solver));
    solvers.push_back(std::move(solver));
  }
#ifdef RICOCHET_HAS_TAO
  for (Solver& solver : tao_solvers()) solvers.push_back(std::move(solver));
#endif
  return solvers;
}

std::vector<MissingSolver> missing_solvers() {
  return {
#ifndef RICOCHET_HAS_IPOPT
      {"ipopt", "Ipopt"},
      {"ipopt-tuned", "Ipopt"},
      {"ipopt-exact", "Ipopt"},
      {"continuation-ipopt-tuned", "Ipopt"},
#endif
#ifndef RICOCHET_HAS_CERES
      {"ceres-lbfgs", "Ceres"},
      {"ceres-trust-region", "Ceres"},
#endif
#ifndef RICOCHET_HAS_PAGMO
      {"pagmo-cmaes", "pagmo"},
      {"pagmo-cmaes-tuned", "pagmo"},
      {"pagmo-cmaes-ipop", "pagmo"},
      {"pagmo-xnes", "pagmo"},
      {"pagmo-de", "pagmo"},
      {"pagmo-sade", "pagmo"},
      {"pagmo-de1220", "pagmo"},
      {"pagmo-gaco", "pagmo"},
      {"pagmo-compass-search", "pagmo"},
      {"pagmo-constrained-de", "pagmo"},
#endif
#ifndef RICOCHET_HAS_TAO
      {"tao-blmvm", "TAO"},
      {"tao-bqnls", "TAO"},
      {"tao-bncg", "TAO"},
      {"tao-pounders", "TAO"},
      {"tao-brgn", "TAO"},
#endif
#ifndef RICOCHET_HAS_DLIB
      {"dlib-global-search", "dlib"},
#endif
  };
}

}  // namespace ricochet
