#include "src/studies/best_values/search.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "solvers/solvers.h"
#include "src/core/run.h"
#include "src/core/verdict.h"

namespace ricochet::studies::best_values {
namespace {

/// Smoothing widths of what solvers with derivatives are shown.
constexpr double widths[] = {0.25, 0.1};

/// The best point so far, and who found it.
struct Best {
  std::optional<Truth> truth;
  Vector x;
  std::string finder;
};

/// Nothing where this build lacks it.
const Solver* solver_named(const std::string& name) {
  static const std::vector<Solver> solvers = all_solvers();
  const auto found = std::find_if(solvers.begin(), solvers.end(),
                                  [&](const Solver& solver) { return solver.name == name; });
  return found == solvers.end() ? nullptr : &*found;
}

/// Runs the solver, from the best point on if `on`, and keeps what is better.
void improve(const Question& question, double width, const std::string& solver_name,
             std::int64_t evaluations, bool on, Best& best) {
  const Solver* found = solver_named(solver_name);
  if (!found) return;
  const Solver& solver = *found;
  Problem problem = question.problem({width});
  if (problem.constraints > 0 && !solver.accepts(problem))
    problem = question.problem({width, true});
  if (!solver.accepts(problem)) return;
  if (on && best.truth) problem.start = best.x;
  const RunRecord record = run(problem, solver, Budget{evaluations}, 0);
  if (!record.failure.empty()) throw std::runtime_error(problem.name + ": " + record.failure);
  if (record.trace.empty()) return;
  const Improvement& last = record.trace.back();
  if (best.truth && !better(last.truth, *best.truth)) return;
  best = {last.truth, last.x,
          fmt::format("{}, seed {}, {} of {} evaluations", solver.name, record.seed,
                      last.evaluations, evaluations)};
}

BestKnown known(const Truth& truth, const Vector& x, std::string provenance) {
  if (truth.violation > 0) {
    return {std::numeric_limits<double>::infinity(), Vector(), std::move(provenance)};
  }
  return {truth.objective, x, std::move(provenance)};
}

}  // namespace

BestKnown search_for_best(const Question& question, const Effort& effort) {
  const std::int64_t evaluations =
      effort.evaluations + effort.evaluations_per_variable * question.stated.dimension();
  Best best;
  for (const char* solver : {"pagmo-cmaes", "pagmo-sade", "fireworks"}) {
    improve(question, 0, solver, evaluations, false, best);
  }
  std::vector<double> shown = {0};
  if (question.stated.smoothed) shown.insert(shown.end(), std::begin(widths), std::end(widths));
  for (const double width : shown) {
    for (const char* solver : {"nlopt-slsqp", "ipopt-tuned"}) {
      improve(question, width, solver, evaluations, false, best);
      improve(question, width, solver, evaluations / 2, true, best);
    }
  }
  improve(question, 0, "ceres-trust-region", evaluations, true, best);
  for (const char* solver : {"nlopt-sbplx", "nlopt-cobyla"}) {
    improve(question, 0, solver, evaluations / 2, true, best);
  }
  if (!best.truth) throw std::runtime_error(question.name() + ": no solver has found a point");
  // Dual numbers round otherwise than plain ones: the value is that of the plain evaluation.
  return known(truth_at(question.stated, best.x), best.x, best.finder);
}

BestKnown best_of(const Question& question, const Effort& effort) {
  return question.stated.dimension() == 1 ? scan_for_best(question.stated, question.scan_step)
                                          : search_for_best(question, effort);
}

}  // namespace ricochet::studies::best_values
