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

namespace ricochet::studies::best_values {
namespace {

/// Smoothing parameters of the surrogates for solvers with derivatives.
constexpr double smoothings[] = {0.25, 0.1};

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

/// Runs the solver, from the best point if `on`, and keeps improvements.
void improve(const Problem& problem, double smoothing, const std::string& solver_name,
             std::int64_t evaluations, bool on, Best& best) {
  const Solver* found = solver_named(solver_name);
  if (!found) return;
  const Solver& solver = *found;
  Problem formulated = problem.formulated({smoothing});
  if (formulated.constraints > 0 && !solver.accepts(formulated)) {
    formulated = problem.formulated({smoothing, true});
  }
  if (!solver.accepts(formulated)) return;
  if (on && best.true_values) formulated.start = best.x;
  const RunRecord record = run(formulated, solver, Budget{evaluations}, 0);
  if (!record.failure.empty()) throw std::runtime_error(problem.name + ": " + record.failure);
  if (record.trace.empty()) return;
  const Improvement& last = record.trace.back();
  if (best.true_values && !better(last.true_values, *best.true_values)) return;
  best = {last.true_values, last.x,
          fmt::format("{}, seed {}, {} of {} evaluations", solver.name, record.seed,
                      last.evaluations, evaluations)};
}

BestKnown known(const TrueValues& true_values, const Vector& x, std::string provenance) {
  if (true_values.violation > 0) {
    return {std::numeric_limits<double>::infinity(), Vector(), std::move(provenance)};
  }
  return {true_values.objective, x, std::move(provenance)};
}

}  // namespace

BestKnown search_for_best(const Problem& problem, const Effort& effort) {
  const std::int64_t evaluations =
      effort.evaluations + effort.evaluations_per_variable * problem.dimension();
  Best best;
  for (const char* solver : {"pagmo-cmaes", "pagmo-sade", "fireworks"}) {
    improve(problem, 0, solver, evaluations, false, best);
  }
  std::vector<double> shown = {0};
  if (problem.smoothed) shown.insert(shown.end(), std::begin(smoothings), std::end(smoothings));
  for (const double smoothing : shown) {
    for (const char* solver : {"nlopt-slsqp", "ipopt-tuned"}) {
      improve(problem, smoothing, solver, evaluations, false, best);
      improve(problem, smoothing, solver, evaluations / 2, true, best);
    }
  }
  improve(problem, 0, "ceres-trust-region", evaluations, true, best);
  for (const char* solver : {"nlopt-sbplx", "nlopt-cobyla"}) {
    improve(problem, 0, solver, evaluations / 2, true, best);
  }
  if (!best.true_values) throw std::runtime_error(problem.name + ": no solver has found a point");
  // Dual numbers round differently: store the value of the plain evaluation.
  return known(true_values_at(problem, best.x), best.x, best.finder);
}

BestKnown best_of(const Problem& problem, const Effort& effort) {
  return problem.dimension() == 1 ? scan_for_best(problem, problem.scan_step)
                                  : search_for_best(problem, effort);
}

}  // namespace ricochet::studies::best_values
