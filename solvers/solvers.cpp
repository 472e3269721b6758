#include <fmt/format.h>

#include "ricochet/error.h"
#include "ricochet/solver.h"
#include "solvers/automatic.h"
#include "solvers/fireworks/fireworks.h"
#include "solvers/library_solvers.h"
#include "solvers/mads.h"
#include "solvers/nlopt.h"
#include "solvers/pagmo.h"
#include "src/core/names.h"

namespace ricochet {

std::vector<Solver> all_solvers() {
  std::vector<Solver> solvers = {
      random_search(),
      scan(),
      bisection(),
      golden_section(),
      mads(Settings::own),
      mads(Settings::tuned),
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
      pagmo_cmaes_ipop(Settings::own),
      pagmo_cmaes_ipop(Settings::tuned),
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
  for (Solver& solver : scipy_solvers()) solvers.push_back(std::move(solver));
  solvers.push_back(automatic(solvers));
  return solvers;
}

std::vector<MissingSolver> missing_solvers() {
  std::vector<MissingSolver> missing = {
#ifndef RICOCHET_HAS_IPOPT
      {"ipopt", "Ipopt", ipopt_capabilities},
      {"ipopt-tuned", "Ipopt", ipopt_capabilities},
      {"ipopt-exact", "Ipopt", ipopt_exact_capabilities},
      {"continuation-ipopt-tuned", "Ipopt", continuation_capabilities(ipopt_capabilities)},
#endif
#ifndef RICOCHET_HAS_CERES
      {"ceres-lbfgs", "Ceres", ceres_lbfgs_capabilities},
      {"ceres-trust-region", "Ceres", ceres_least_squares_capabilities},
#endif
#ifndef RICOCHET_HAS_PAGMO
      {"pagmo-cmaes", "pagmo", pagmo_bounds_only},
      {"pagmo-cmaes-tuned", "pagmo", pagmo_bounds_only},
      {"pagmo-cmaes-ipop", "pagmo", pagmo_bounds_only},
      {"pagmo-cmaes-ipop-tuned", "pagmo", pagmo_bounds_only},
      {"pagmo-xnes", "pagmo", pagmo_bounds_only},
      {"pagmo-de", "pagmo", pagmo_bounds_only},
      {"pagmo-sade", "pagmo", pagmo_bounds_only},
      {"pagmo-de1220", "pagmo", pagmo_bounds_only},
      {"pagmo-gaco", "pagmo", pagmo_all_constraints},
      {"pagmo-compass-search", "pagmo", pagmo_all_constraints},
      {"pagmo-constrained-de", "pagmo", pagmo_needs_constraints},
#endif
#ifndef RICOCHET_HAS_TAO
      {"tao-blmvm", "TAO", tao_gradient_capabilities},
      {"tao-bqnls", "TAO", tao_gradient_capabilities},
      {"tao-bncg", "TAO", tao_gradient_capabilities},
      {"tao-pounders", "TAO", tao_residual_capabilities},
      {"tao-brgn", "TAO", tao_residual_capabilities},
#endif
#ifndef RICOCHET_HAS_DLIB
      {"dlib-global-search", "dlib", dlib_capabilities},
#endif
  };
  if (scipy_solvers().empty()) {
    for (const ScipySolver& each : scipy_list) {
      missing.push_back({each.name, "SciPy", each.capabilities});
    }
  }
  return missing;
}

Solver solver_named(const std::string& name, const std::string& asked_by) {
  std::vector<std::string> known;
  const std::vector<Solver> solvers = all_solvers();
  for (const Solver& solver : solvers) known.push_back(solver.name);
  if (const std::string* found = match(name, known)) {
    return solvers[static_cast<std::size_t>(found - known.data())];
  }
  for (const MissingSolver& missing : missing_solvers()) {
    if (missing.solver != name) continue;
    throw InputError(fmt::format("{} {}: this build has no {}; see `ricochet list solvers`",
                                 asked_by, name, missing.library));
  }
  throw InputError(fmt::format("{} {}: there is no such solver; {}", asked_by, name,
                               what_instead(name, known, "`ricochet list solvers`")));
}

}  // namespace ricochet
