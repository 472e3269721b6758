#include "src/research/best_values/search.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "ricochet/run.h"
#include "ricochet/solvers.h"
#include "ricochet/verdict.h"
#include "src/research/best_values/known_values.h"

namespace ricochet::studies::best_values {
namespace {

/// The best point so far, and the solver that found it.
struct Best {
  std::optional<TrueValues> true_values;
  Vector x;
  std::string finder;
};

/// Null if this build does not have it.
const Solver* solver_named(const std::string& name) {
  static const std::vector<Solver> solvers = all_solvers();
  const auto found = std::find_if(solvers.begin(), solvers.end(),
                                  [&](const Solver& solver) { return solver.name == name; });
  return found == solvers.end() ? nullptr : &*found;
}

/// Runs the solver, from the best point if there is one, and keeps improvements.
void improve(const Problem& problem, double smoothing, const std::string& solver_name,
             std::int64_t evaluations, int number, Best& best) {
  const Solver* solver = solver_named(solver_name);
  if (!solver) return;
  Problem formulated = problem.formulated({smoothing});
  if (formulated.constraints > 0 && !solver->accepts(formulated)) {
    formulated = problem.formulated({smoothing, true});
  }
  if (!solver->accepts(formulated)) return;
  if (best.true_values) {
    formulated.start = best.x;
    number = 0;  // from there
  }
  const RunRecord record = run(formulated, *solver, Budget{evaluations}, number);
  if (!record.failure.empty()) throw std::runtime_error(problem.name + ": " + record.failure);
  if (record.trace.empty()) return;
  const Improvement& last = record.trace.back();
  if (best.true_values && !better(last.true_values, *best.true_values)) return;
  best = {last.true_values, last.x, finder_of(record)};
}

/// The solvers that do best on problems with derivatives, and without.
std::vector<std::string> searchers_of(const Problem& problem) {
  if (problem.differentiate) return {"nlopt-slsqp", "nlopt-ccsaq", "pagmo-cmaes-ipop"};
  return {"pagmo-cmaes-ipop", "nlopt-crs2", "mads"};
}

Best searched(const Problem& problem, const std::string& solver, std::int64_t evaluations,
              int number) {
  Best best;
  improve(problem, 0, solver, evaluations, number, best);
  const std::int64_t more = std::max<std::int64_t>(1, evaluations / 20);
  if (problem.smoothed) improve(problem, problem.smoothing, "nlopt-slsqp", more, 0, best);
  for (const char* local : {"nlopt-slsqp", "nlopt-cobyla", "nlopt-sbplx"}) {
    improve(problem, 0, local, more, 0, best);
  }
  return best;
}

/// The problem's best known point, evaluated by this version.
Best known_best(const Problem& problem) {
  if (!problem.best_point) return {};
  const std::string finder = problem.provenance.substr(0, problem.provenance.find("; "));
  return {true_values_at(problem, *problem.best_point), *problem.best_point, finder};
}

/// The number of searches that end within the tolerance of the best.
int agreeing(const std::vector<Best>& searches, const Best& best, double tolerance) {
  return static_cast<int>(std::ranges::count_if(searches, [&](const Best& search) {
    return search.true_values && search.true_values->violation <= best.true_values->violation &&
           search.true_values->objective <= best.true_values->objective + tolerance;
  }));
}

BestKnown known(const TrueValues& true_values, const Vector& x, std::string provenance) {
  if (true_values.violation > 0) {
    return {std::numeric_limits<double>::infinity(), Vector(), std::move(provenance)};
  }
  return {true_values.objective, x, std::move(provenance)};
}

}  // namespace

BestKnown search_for_best(const Problem& problem, const Effort& effort) {
  const std::vector<std::string> searchers = searchers_of(problem);
  const std::int64_t evaluations = effort.evaluations_per_variable * problem.dimension();
  Best best = known_best(problem);
  std::vector<Best> searches;
  int agree = 0;
  for (int number = 0; number < effort.rounds && agree < 2; ++number) {
    for (std::size_t k = 0; k < searchers.size() && agree < 2; ++k) {
      const Best found = searched(problem, searchers[k], evaluations, number);
      if (!found.true_values) continue;
      if (!best.true_values || better(*found.true_values, *best.true_values)) best = found;
      searches.push_back(found);
      agree = agreeing(searches, best, problem.tolerance);
    }
  }
  if (searches.empty()) throw std::runtime_error(problem.name + ": no solver has found a point");
  // Dual numbers round differently: store the value of the plain evaluation.
  return known(true_values_at(problem, best.x), best.x,
               fmt::format("{}; {} of {} searches of {} evaluations agree", best.finder, agree,
                           searches.size(), evaluations));
}

BestKnown best_of(const Problem& problem, const Effort& effort) {
  return problem.dimension() == 1 ? scan_for_best(problem, problem.scan_step)
                                  : search_for_best(problem, effort);
}

}  // namespace ricochet::studies::best_values
