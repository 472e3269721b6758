#include "solvers/nlopt/nlopt.h"

#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <initializer_list>

#include "solvers/nlopt/algorithm.h"
#include "solvers/nlopt/search.h"

namespace ricochet {
namespace {

Solver solver_of(const NloptAlgorithm& algorithm) {
  int version[3];
  nlopt_version(&version[0], &version[1], &version[2]);
  Solver solver;
  solver.name = fmt::format("nlopt-{}", algorithm.name);
  solver.version = fmt::format("NLopt {} (adapter 2)", fmt::join(version, "."));
  solver.stochastic = algorithm.draws;
  solver.capabilities = algorithm.capabilities;
  solver.at_limit = AtLimit::own_point;
  solver.solve = [algorithm](Evaluator& evaluator, const Vector& start, Random& random) {
    return NloptSearch(algorithm, evaluator, random()).from(start);
  };
  return solver;
}

/// The options that affect this algorithm.
std::vector<SolverOption> options_of(const NloptAlgorithm& algorithm) {
  const auto is_one_of = [&](std::initializer_list<nlopt_algorithm> ids) {
    return std::find(ids.begin(), ids.end(), algorithm.id) != ids.end();
  };
  std::vector<SolverOption> options;
  const bool starts_anew = algorithm.id == NLOPT_G_MLSL_LDS;
  if (starts_anew || is_one_of({NLOPT_GN_CRS2_LM, NLOPT_GN_ISRES, NLOPT_GN_ESCH})) {
    options.push_back(whole_option("population", 1, "NLopt's own"));
  }
  if (is_one_of({NLOPT_LN_COBYLA, NLOPT_LN_BOBYQA, NLOPT_LN_NELDERMEAD, NLOPT_LN_SBPLX})) {
    options.push_back(real_option("initial_step", 1e-6, 1, algorithm.initial_step));
  }
  if (is_one_of({NLOPT_LD_LBFGS, NLOPT_LD_VAR2, NLOPT_LD_TNEWTON_PRECOND_RESTART})) {
    SolverOption vectors = whole_option("vectors", 1, algorithm.vectors);
    vectors.most = 1000;
    options.push_back(vectors);
  }
  const bool looks_everywhere =
      algorithm.is_original_direct() ||
      is_one_of({NLOPT_GN_CRS2_LM, NLOPT_GN_ISRES, NLOPT_GN_ESCH, NLOPT_GN_AGS});
  if (!looks_everywhere) {
    options.push_back(real_option("tolerance", 1e-15, 0.1, algorithm.tolerance));
  }
  return options;
}

}  // namespace

std::vector<Solver> nlopt_solvers() {
  std::vector<Solver> solvers;
  for (const NloptAlgorithm& algorithm : nlopt_algorithms()) {
    solvers.push_back(solver_of(algorithm));
  }
  return solvers;
}

std::vector<AdjustableSolver> adjustable_nlopt() {
  std::vector<AdjustableSolver> solvers;
  for (const NloptAlgorithm& algorithm : nlopt_algorithms()) {
    const std::vector<SolverOption> options = options_of(algorithm);
    if (options.empty()) continue;
    solvers.push_back({fmt::format("nlopt-{}", algorithm.name), options,
                       [own = algorithm](const GivenOptions& given) {
                         NloptAlgorithm changed = own;
                         changed.population = whole_of(given, "population", own.population);
                         changed.initial_step = number_of(given, "initial_step", own.initial_step);
                         changed.vectors = whole_of(given, "vectors", own.vectors);
                         changed.tolerance = number_of(given, "tolerance", own.tolerance);
                         return solver_of(changed);
                       }});
  }
  return solvers;
}

}  // namespace ricochet
