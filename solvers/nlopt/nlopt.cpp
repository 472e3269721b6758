#include "solvers/nlopt/nlopt.h"

#include <fmt/format.h>
#include <nlopt.h>

#include "solvers/nlopt/algorithm.h"
#include "solvers/nlopt/search.h"

namespace ricochet {

std::vector<Solver> nlopt_solvers() {
  int version[3];
  nlopt_version(&version[0], &version[1], &version[2]);
  std::vector<Solver> solvers;
  for (const NloptAlgorithm& algorithm : nlopt_algorithms()) {
    Solver solver;
    solver.name = fmt::format("nlopt-{}", algorithm.name);
    solver.version = fmt::format("NLopt {}", fmt::join(version, "."));
    solver.stochastic = algorithm.draws;
    solver.accepts = [algorithm](const Problem& problem) { return algorithm.accepts(problem); };
    solver.solve = [algorithm](Evaluator& evaluator, const Vector& start, Random& random) {
      nlopt_srand(random());  // the state is this thread's own, left over from its last run
      return NloptSearch(algorithm, evaluator).from(start);
    };
    solvers.push_back(solver);
  }
  return solvers;
}

}  // namespace ricochet
