#include "solvers/continuation.h"

#include <fmt/format.h>

#include "solvers/unit_box.h"

namespace ricochet {
namespace {

constexpr double widest = 0.3;
constexpr double narrowest = 1e-3;
constexpr double narrowing = 0.5;

/// What one width may cost, in values with derivatives: some solvers cycle.
constexpr std::int64_t most_steps = 30;

constexpr double first_step = 1e-5;  // of the box
constexpr int bisections = 6;

Vector inside(const Vector& x, const Problem& problem) {
  return x.cwiseMax(problem.lower).cwiseMin(problem.upper);
}

/// Where a smooth constraint ends, the true one does not. Goes from `x` on a straight line to where
/// the true ones change from broken to kept: where they are broken, down the slope of the smooth
/// constraint that is broken most, else down that of the objective. The evaluator shows the
/// narrowest width.
void settle(Evaluator& evaluator, const Vector& x) {
  const Problem& problem = evaluator.problem();
  const auto seen = evaluator.derivatives(x);
  if (!seen || !finite(*seen)) return;
  Eigen::Index worst = 0;
  seen->values.constraints.maxCoeff(&worst);
  const Vector width = problem.upper - problem.lower;
  evaluator.smooth(0);
  const auto holds = [&](const Vector& point) {
    const auto values = evaluator.values(point);
    return values && truth_of(*values).violation <= 0;
  };
  const bool kept = holds(x);
  const Vector slope =
      (kept ? seen->gradient : Vector(seen->jacobian.row(worst))).cwiseProduct(width);
  if (!(slope.norm() > 0)) return;
  const auto at = [&](double share) {
    return inside(x - share / slope.norm() * slope.cwiseProduct(width), problem);
  };
  double near = 0;
  double far = first_step;
  while (holds(at(far)) == kept) {
    if (evaluator.over() || far >= 1) return;
    near = far;
    far *= 2;
  }
  for (int i = 0; i < bisections && !evaluator.over(); ++i) {
    const double middle = (near + far) / 2;
    (holds(at(middle)) == kept ? near : far) = middle;
  }
}

}  // namespace

Solver continuation(Solver solver) {
  Solver result = solver;
  result.name = fmt::format("continuation-{}", solver.name);
  result.accepts = [accepts = solver.accepts](const Problem& problem) {
    return problem.smoothed && problem.differentiate && problem.equalities == 0 && accepts(problem);
  };
  result.solve = [solve = solver.solve](Evaluator& evaluator, const Vector& start,
                                        Random& random) -> SolverExit {
    const Problem& problem = evaluator.problem();
    const std::int64_t most = most_steps * (1 + problem.dimension());
    Vector x = start;
    SolverExit exit;
    for (double width = widest; width > narrowest; width *= narrowing) {
      evaluator.smooth(width);
      evaluator.allow(most);
      exit = solve(evaluator, x, random);
      evaluator.allow(most);
      if (evaluator.over()) break;
      if (evaluator.best_shown() != nullptr) x = *evaluator.best_shown();
    }
    if (problem.constraints > 0 && !evaluator.over()) settle(evaluator, x);
    exit.point.reset();  // that of one width; the best shown at the last one is the answer
    return exit;
  };
  return result;
}

}  // namespace ricochet
