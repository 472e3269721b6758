#include "solvers/continuation.h"

#include <fmt/format.h>

#include "solvers/unit_box.h"

namespace ricochet {
namespace {

constexpr double widest = 0.3;
constexpr double narrowest = 1e-3;
constexpr double narrowing = 0.5;

/// Most values with derivatives that one smoothing parameter may cost: some solvers cycle.
constexpr std::int64_t most_steps = 30;

constexpr double first_step = 1e-5;  // of the box
constexpr int bisections = 6;

/// Corrects for the distance between the limits of the smooth and of the true constraints. Goes
/// from `x` along a straight line to where the true constraints change between broken and kept: if
/// they are broken at `x`, down the slope of the smooth constraint that is broken most, else down
/// the slope of the objective. The evaluator must show the smallest smoothing parameter.
void settle(Evaluator& evaluator, const Vector& x) {
  const auto seen = evaluator.derivatives(x);
  if (!seen || !finite(*seen)) return;
  Eigen::Index worst = 0;
  seen->values.constraints.maxCoeff(&worst);
  const Vector width = evaluator.upper() - evaluator.lower();
  evaluator.smooth(0);
  const auto holds = [&](const Vector& point) {
    const auto values = evaluator.values(point);
    return values && true_values_of(*values).violation <= 0;
  };
  const bool kept = holds(x);
  const Vector slope =
      (kept ? seen->gradient : Vector(seen->jacobian.row(worst))).cwiseProduct(width);
  if (!(slope.norm() > 0)) return;
  const auto at = [&](double share) -> Vector {
    const Vector there = x - share / slope.norm() * slope.cwiseProduct(width);
    return there.cwiseMax(evaluator.lower()).cwiseMin(evaluator.upper());
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

Capabilities continuation_capabilities(const Capabilities& of) {
  Capabilities result = of;
  result.constraints = std::min(of.constraints, Capabilities::Constraints::inequalities);
  result.derivatives = std::max(of.derivatives, Capabilities::Order::gradient);
  result.needs_smoothing = true;
  return result;
}

Solver continuation(Solver solver) {
  Solver result = solver;
  result.name = fmt::format("continuation-{}", solver.name);
  result.capabilities = continuation_capabilities(solver.capabilities);
  result.at_limit = AtLimit::best_evaluated;
  result.solve = [solve = solver.solve](Evaluator& evaluator, const Vector& start,
                                        Random& random) -> SolverTermination {
    const std::int64_t most = most_steps * (1 + evaluator.dimension());
    Vector x = start;
    SolverTermination exit;
    for (double smoothing = widest; smoothing > narrowest; smoothing *= narrowing) {
      evaluator.smooth(smoothing);
      evaluator.allow(most);
      exit = solve(evaluator, x, random);
      evaluator.allow(most);
      if (evaluator.over()) break;
      if (evaluator.best_shown() != nullptr) x = *evaluator.best_shown();
    }
    if (evaluator.constraints() > 0 && !evaluator.over()) settle(evaluator, x);
    exit.point
        .reset();  // of this smoothing parameter only; the best point at the last one is returned
    return exit;
  };
  return result;
}

}  // namespace ricochet
