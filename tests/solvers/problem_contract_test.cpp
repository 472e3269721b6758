// What solvers promise of constraints, of derivatives that are not finite, and of what they declare
// to need.

#include "tests/solvers/solve.h"

namespace ricochet {
namespace {

/// What a count exceeds its limit by, on [0, 18]^n from 13: 0 where no coordinate is 2 or more
/// from 7, more elsewhere, nowhere less. The objective falls towards the pocket's upper corner, and
/// beyond. With slopes that show the way, as a surrogate has.
Problem pocket(Eigen::Index n) {
  Problem problem = box_problem("pocket", n, 0, 18, 13, [](const Vector& x) { return -x.sum(); });
  problem.constraints = 1;
  problem.evaluate = [](const Vector& x) {
    const double away = (x.array() - 7).abs().maxCoeff();
    return Values{-x.sum(), Vector::Constant(1, std::floor(away / 2))};
  };
  const auto slopes = [n](const Vector& x) -> Matrix {
    Eigen::Index farthest = 0;
    (x.array() - 7).abs().maxCoeff(&farthest);
    return (x[farthest] > 7 ? 0.5 : -0.5) * Vector::Unit(n, farthest).transpose();
  };
  differentiate_by(
      problem, [n](const Vector&) -> Vector { return -Vector::Ones(n); }, slopes);
  curve_by(problem, constant_hessian(n, 0));
  return with_idle_knob(problem);
}

/// `problem` with its constraints, which are of size 1, in another unit.
Problem with_constraints_times(double factor, const Problem& problem) {
  Problem scaled = problem;
  scaled.evaluate = [factor, evaluate = problem.evaluate](const Vector& x) {
    Values values = evaluate(x);
    values.constraints *= factor;
    return values;
  };
  scaled.differentiate = [factor, differentiate = problem.differentiate](const Vector& x) {
    Derivatives derivatives = differentiate(x);
    derivatives.values.constraints *= factor;
    derivatives.jacobian *= factor;
    return derivatives;
  };
  scaled.lagrangian_hessian = [factor, hessian = problem.lagrangian_hessian](
                                  const Vector& x, double objective_factor,
                                  const Vector& multipliers) {
    return hessian(x, objective_factor, factor * multipliers);
  };
  return with_idle_knob(scaled);
}

class ConstraintContract : public OfSolver {};

// A margin in what a solver is shown would leave it no feasible point at all.
TEST_P(ConstraintContract, ReturnsAPointAtItsLimit) {
  const Problem problem = pocket(solver().accepts(pocket(1)) ? 1 : 2);
  const RunRecord record = run(problem, solver(), {2000}, 0);
  EXPECT_EQ(record.failure, "");
  ASSERT_TRUE(record.returned);
  EXPECT_EQ(problem.evaluate(record.returned->x).constraints[0], 0);
  EXPECT_EQ(record.returned->true_values.violation, 0);
}

TEST_P(ConstraintContract, ReturnsFeasiblePointsWhereItSaysThatItHasConverged) {
  // COBYLA says "xtol reached" at a short step, whatever the violation; this step is 1e-4 of the
  // box.
  if (solver().name == "nlopt-cobyla-tuned") GTEST_SKIP() << "it claims nothing of constraints";
  const std::set<std::string> claims = {"solved",       "solved to an acceptable level",
                                        "xtol reached", "ftol reached",
                                        "success",      "converged"};
  for (const double factor : {1.0, 100.0, 0.01}) {
    for (const Problem& stated : {disc(), arc()}) {
      const Problem problem = with_constraints_times(factor, stated);
      if (!solver().accepts(problem)) continue;
      // DIRECT keeps all its boxes: its time grows with the square of the evaluations.
      const bool divides = solver().name.starts_with("nlopt-direct");
      const Solved end = solved(problem, solver(), divides ? 1000 : 5000, 1);
      if (!claims.contains(end.reason) || !end.point) continue;
      EXPECT_EQ(true_values_at(problem, *end.point).violation, 0)
          << stated.name << " with constraints times " << factor << ", " << end.reason;
    }
  }
}

TEST_P(ConstraintContract, FindsAFeasiblePointNearTheConstrainedOptimum) {
  if (!solver().accepts(disc())) GTEST_SKIP() << "it takes no such problem";
  // With 1000 evaluations dynFWA gets to its seventh generation only.
  const bool stochastic = solver().stochastic;
  const TrueValues best = best_of(run(disc(), solver(), {stochastic ? 5000 : 1000}, 0));
  EXPECT_EQ(best.violation, 0.0);
  EXPECT_GE(best.objective, -std::sqrt(2.0) - constraint_tolerance);
  EXPECT_LT(best.objective, stochastic ? -1.3 : -1.39);
}

INSTANTIATE_TEST_SUITE_P(Of, ConstraintContract,
                         testing::ValuesIn(solvers_that([](const Solver& solver) {
                           return solver.accepts(pocket(1)) || solver.accepts(pocket(2));
                         })),
                         by_solver);

/// Which derivatives are not finite.
enum class Broken { gradient, jacobian, hessian };

/// Where they are not; the start is at 1.5.
enum class Where { everywhere, at_the_start, away_from_the_start };

/// disc() with residuals, whose values are finite everywhere and whose derivatives have one number
/// `bad` in a region; or the sum of (x_i + 1)^2 without constraints, where a gradient that is not
/// finite stands for a Jacobian.
Problem with_bad_derivatives(Broken broken, double bad, Where where, bool constrained) {
  Problem problem = constrained ? disc() : sphere(2, -1);
  problem.lower = disc().lower;
  problem.upper = disc().upper;
  problem.start = disc().start;
  const auto is_hit = [=](Broken which, const Vector& x) {
    const bool is_inside =
        where == Where::everywhere || (where == Where::at_the_start ? x.sum() > 2.9 : x.sum() < 1);
    return is_inside && broken == which;
  };
  problem.differentiate = [=, differentiate = problem.differentiate](const Vector& x) {
    Derivatives derivatives = differentiate(x);
    if (is_hit(Broken::gradient, x)) derivatives.gradient[1] = bad;
    if (is_hit(Broken::jacobian, x)) {
      (constrained ? derivatives.jacobian(0, 1) : derivatives.gradient[1]) = bad;
    }
    return derivatives;
  };
  problem.lagrangian_hessian = [=, hessian = problem.lagrangian_hessian](
                                   const Vector& x, double factor, const Vector& multipliers) {
    Matrix told = hessian(x, factor, multipliers);
    if (is_hit(Broken::hessian, x)) told(1, 0) = told(0, 1) = bad;
    return told;
  };
  problem.residuals = [=](const Vector& x) {
    Residuals told = distances(x, -1);
    if (is_hit(Broken::jacobian, x)) told.jacobian(0, 1) = bad;
    return told;
  };
  return with_idle_knob(problem);
}

class DerivativesContract : public OfSolver {};

// Where what it needs is nowhere finite, no start may end as if it had converged.
TEST_P(DerivativesContract, EndsEveryStartWhereADerivativeIsNotFinite) {
  // "failure" is Ceres's word for it; MLSL goes on to its next start until it is stopped.
  const auto is_honest =
      testing::AnyOf("a number is not finite", "failure", "stopped by the evaluator");
  const Broken needed = solver().capabilities.needs_residuals ? Broken::jacobian : Broken::gradient;
  int runs = 0;
  for (const Broken broken : {Broken::gradient, Broken::jacobian, Broken::hessian}) {
    for (const double bad : {quiet_nan, infinity, -infinity, 1e300}) {
      for (const Where where :
           {Where::everywhere, Where::at_the_start, Where::away_from_the_start}) {
        for (const bool constrained : {true, false}) {
          const Problem problem = with_bad_derivatives(broken, bad, where, constrained);
          if (!solver().accepts(problem)) continue;
          SCOPED_TRACE(fmt::format("region {}, derivative {}", static_cast<int>(where), bad));
          const RunRecord record = run(problem, solver(), {300}, 0);
          ++runs;
          EXPECT_EQ(record.failure, "");
          EXPECT_FALSE(record.terminations.empty());
          EXPECT_LE(record.ledger.charged, 300);
          if (broken != needed || where != Where::everywhere || bad == 1e300) continue;
          if (solver().name == "tao-pounders") continue;  // it needs residuals, but no derivatives
          EXPECT_THAT(reasons_of(record), Each(is_honest));
        }
      }
    }
  }
  EXPECT_GT(runs, 0);
}

INSTANTIATE_TEST_SUITE_P(Of, DerivativesContract,
                         testing::ValuesIn(solvers_that([](const Solver& solver) {
                           return solver.capabilities.needs_residuals ||
                                  solver.capabilities.derivatives != Capabilities::Order::value;
                         })),
                         by_solver);

/// The problem, smoothed or not, without what `remove` takes away.
Problem without(const Problem& problem, void (*remove)(Problem&)) {
  Problem result = problem;
  if (problem.smoothed) {
    result.smoothed = [smoothed = problem.smoothed, remove](double parameter) {
      return without(smoothed(parameter), remove);
    };
  }
  remove(result);
  return result;
}

/// Returns true if the solver evaluates points, and neither it nor the problem fails.
bool runs(const Solver& solver, const Problem& problem) {
  const RunRecord record = run(problem, solver, {200}, 0);
  return record.failure.empty() && record.ledger.charged > 0 && !record.trace.empty() &&
         std::ranges::count(reasons_of(record), "invalid arguments") == 0;
}

class DeclaredCapabilities : public OfSolver {};

// One to sixteen variables; no constraints, inequalities, an equality, both; with and without
// derivatives of all orders, residuals and smoothing: these in every formulation.
TEST_P(DeclaredCapabilities, AreEnoughAndNameWhatItCannotDoWithout) {
  int accepted = 0;
  for (const char* name : {"count-C4", "top-speed-C1", "profile-count-8-C4", "profile-wear-16-C4",
                           "design-count-C4", "classic-rosenbrock-5", "hs-1", "hs-6", "hs-10",
                           "hs-71", "least-squares-01-linear-full-rank-9x45"}) {
    const Problem stated = suite_problem(name);
    for (const Formulation& formulation : stated.formulations()) {
      const Problem problem = stated.formulated(formulation);
      if (!solver().accepts(problem)) continue;
      SCOPED_TRACE(name);
      ++accepted;
      EXPECT_TRUE(runs(solver(), problem));
      for (const Problem& less :
           {without(problem, [](Problem& p) { p.differentiate = nullptr; }),
            without(problem, [](Problem& p) { p.lagrangian_hessian = nullptr; }),
            without(problem, [](Problem& p) { p.residuals = nullptr; }),
            without(problem, [](Problem& p) { p.smoothed = nullptr; })}) {
        EXPECT_EQ(runs(solver(), less), solver().accepts(less));
      }
    }
  }
  EXPECT_GT(accepted, 0);
}

INSTANTIATE_TEST_SUITE_P(Of, DeclaredCapabilities, testing::ValuesIn(all_solvers()), by_solver);

}  // namespace
}  // namespace ricochet
