#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "solvers/library_solvers.h"
#include "solvers/scaled_box.h"

namespace ricochet {

Solver bisection() {
  constexpr double step_tolerance = 1e-8;  // of the box
  Solver solver;
  solver.name = "bisection";
  solver.version = "ricochet " RICOCHET_VERSION;
  solver.capabilities = {.most_variables = 1,
                         .constraints = Capabilities::Constraints::inequalities,
                         .needs_constraints = true};
  solver.solve = [](Evaluator& evaluator, const Vector& start, Random&) -> SolverTermination {
    const Vector &lower = evaluator.lower(), &upper = evaluator.upper();
    const auto at_lower = evaluator.values(lower);
    const auto at_upper = evaluator.values(upper);
    if (!at_upper) return {stopped_by_evaluator};
    const bool upwards = at_upper->objective < at_lower->objective;
    if (true_values_of(upwards ? *at_upper : *at_lower).violation <= 0)
      return {"the end is feasible"};
    Vector feasible = upwards ? lower : upper;  // assumed
    Vector infeasible = upwards ? upper : lower;
    const double width = upper[0] - lower[0];
    for (Vector x = start; std::abs(feasible[0] - infeasible[0]) > step_tolerance * width;
         x = (feasible + infeasible) / 2) {
      const auto values = evaluator.values(x);
      if (!values) return {stopped_by_evaluator};
      (true_values_of(*values).violation <= 0 ? feasible : infeasible) = x;
    }
    return {"the interval is short", feasible};
  };
  return solver;
}

Solver golden_section() {
  constexpr double step_tolerance = 1e-8;  // of the box
  constexpr double section = 2 - std::numbers::phi;
  Solver solver;
  solver.name = "golden-section";
  solver.version = "ricochet " RICOCHET_VERSION;
  solver.capabilities.most_variables = 1;
  solver.solve = [](Evaluator& evaluator, const Vector& start, Random&) -> SolverTermination {
    double a = evaluator.lower()[0], x = start[0], b = evaluator.upper()[0];
    const double width = b - a;
    auto best = evaluator.objective(start);
    while (best && b - a > step_tolerance * width) {
      const double y = b - x > x - a ? x + section * (b - x) : x - section * (x - a);
      const auto there = evaluator.objective(Vector::Constant(1, y));
      if (!there) break;
      const bool better = *there < *best;
      (better == (y > x) ? a : b) = better ? x : y;
      if (better) {
        x = y;
        best = there;
      }
    }
    return {evaluator.over() ? stopped_by_evaluator : "the interval is short",
            Vector::Constant(1, x)};
  };
  return solver;
}

double van_der_corput(std::uint64_t k) {
  double result = 0;
  for (double digit = 0.5; k > 0; k >>= 1, digit /= 2) {
    if (k & 1U) result += digit;
  }
  return result;
}

Solver scan() {
  Solver solver;
  solver.name = "scan";
  solver.version = "ricochet " RICOCHET_VERSION;
  solver.capabilities = {.most_variables = 1,
                         .constraints = Capabilities::Constraints::inequalities};
  solver.solve = [](Evaluator& evaluator, const Vector&, Random&) -> SolverTermination {
    const Vector width = evaluator.upper() - evaluator.lower();
    evaluator.values(evaluator.lower());
    Vector x = evaluator.upper();
    for (std::uint64_t k = 1; evaluator.values(x); ++k) {
      x = evaluator.lower() + van_der_corput(k) * width;
    }
    return {stopped_by_evaluator};
  };
  return solver;
}

Solver random_search() {
  Solver solver;
  solver.name = "random-search";
  solver.version = "ricochet " RICOCHET_VERSION;
  solver.stochastic = true;
  solver.capabilities.constraints = Capabilities::Constraints::inequalities;
  solver.solve = [](Evaluator& evaluator, const Vector& start,
                    Random& random) -> SolverTermination {
    Vector x = start;
    while (evaluator.values(x)) x = uniform_point(evaluator.lower(), evaluator.upper(), random);
    return {stopped_by_evaluator};
  };
  return solver;
}

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
    std::optional<Vector> before;
    SolverTermination exit;
    for (double smoothing = widest; smoothing > narrowest; smoothing *= narrowing) {
      evaluator.smooth(smoothing);
      evaluator.allow(most);
      exit = solve(evaluator, x, random);
      evaluator.allow(most);
      if (evaluator.over()) break;
      if (evaluator.best_shown() != nullptr) before = x = *evaluator.best_shown();
    }
    if (evaluator.constraints() > 0 && !evaluator.over()) settle(evaluator, x);
    // The best point at the last parameter is returned; that of the one before if it shows none.
    exit.point = evaluator.best_shown() == nullptr ? before : std::nullopt;
    return exit;
  };
  return result;
}

}  // namespace ricochet
