#include "ricochet/problem.h"

#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "src/core/evaluator.h"
#include "tests/core/hessian_check.h"
#include "tests/support/problems.h"
#include "tests/support/refusals.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

using testing::ElementsAre;

double violation(const Vector& constraints, Eigen::Index equalities) {
  return true_values_of({0, constraints}, equalities).violation;
}

TEST(Problem, IsViolatedByItsLargestConstraintAndAnEqualityOfEitherSign) {
  EXPECT_EQ(violation(Vector(0), 0), 0);
  EXPECT_EQ(violation(Vector{{-3, -1}}, 0), 0);
  EXPECT_EQ(violation(Vector{{-3, 2, 1}}, 0), 2);
  EXPECT_EQ(violation(Vector{{-3, -1}}, 1), 3);
  EXPECT_EQ(violation(Vector{{3, -1}}, 1), 3);
  EXPECT_EQ(violation(Vector{{0, -1}}, 1), 0);
  EXPECT_EQ(violation(Vector{{-1, 4}}, 1), 4);
}

TEST(Problem, GrantsEveryConstraintTheSameTolerance) {
  constexpr double eps = constraint_tolerance;
  for (const Eigen::Index equalities : {0, 1, 2}) {
    EXPECT_EQ(violation(Vector{{eps, eps}}, equalities), 0);
    EXPECT_EQ(violation(Vector{{2 * eps, 0}}, equalities), 2 * eps);
    EXPECT_EQ(violation(Vector{{0, 2 * eps}}, equalities), 2 * eps);
  }
  EXPECT_EQ(violation(Vector{{-eps, -1}}, 1), 0);
  EXPECT_GT(violation(Vector{{-2 * eps, -1}}, 1), 0);
  EXPECT_EQ(violation(Vector{{-2 * eps, -1}}, 0), 0);
}

TEST(Problem, IsNotFeasibleWhereAConstraintIsNoNumber) {
  for (const Eigen::Index equalities : {0, 1}) {
    EXPECT_TRUE(std::isnan(violation(Vector{{quiet_nan, 2}}, equalities)));
    EXPECT_TRUE(std::isnan(violation(Vector{{2, quiet_nan}}, equalities)));
  }
}

TEST(Problem, OfLessViolationIsBetterThenOneOfALowerObjective) {
  EXPECT_TRUE(better({5, 0}, {1, 1}));
  EXPECT_TRUE(better({1, 1}, {5, 1}));
  EXPECT_FALSE(better({1, 1}, {1, 1}));
}

/// parabola(2), whose coordinates must sum to 1 at least; `smooth`: its surrogate adds the
/// smoothing parameter.
Problem formulable(bool constrained, bool smooth) {
  Problem result = parabola(2);
  result.smoothing = 0.25;
  result.penalty_weight = 10;
  if (constrained) {
    result.constraints = 1;
    result.evaluate = [evaluate = result.evaluate](const Vector& x) {
      return Values{evaluate(x).objective, Vector::Constant(1, 1 - x.sum())};
    };
  }
  if (smooth) {
    result.smoothed = [stated = result](double smoothing) {
      Problem problem = stated;
      problem.evaluate = [stated, smoothing](const Vector& x) {
        Values values = stated.evaluate(x);
        values.objective += smoothing;
        return values;
      };
      problem.true_values = [stated](const Vector& x) {
        return true_values_of(stated.evaluate(x));
      };
      return problem;
    };
  }
  return result;
}

std::vector<std::string> names_of_formulations(const Problem& problem,
                                               const std::vector<double>& smoothings = {}) {
  std::vector<std::string> names;
  for (const Formulation& formulation : problem.formulations(smoothings))
    names.push_back(problem.name_of(formulation));
  return names;
}

TEST(Problem, HasTheFormulationsThatItsConstraintsAndItsKnobAllow) {
  EXPECT_THAT(names_of_formulations(formulable(false, false)), ElementsAre("original"));
  EXPECT_THAT(names_of_formulations(formulable(true, false), {0.1}),
              ElementsAre("original", "penalised"));
  EXPECT_THAT(names_of_formulations(formulable(false, true)), ElementsAre("count", "surrogate"));
  const Problem both = formulable(true, true);
  EXPECT_THAT(names_of_formulations(both),
              ElementsAre("count", "penalised-count", "surrogate", "penalised-surrogate"));
  EXPECT_THAT(names_of_formulations(both, {0.1, both.smoothing}),
              ElementsAre("count", "penalised-count", "surrogate", "penalised-surrogate",
                          "surrogate-0.1", "penalised-surrogate-0.1"))
      << "every smoothing once";
}

TEST(Problem, KnowsItsFormulationsByTheirNames) {
  const Problem asked = formulable(true, true);
  for (const Formulation& formulation : asked.formulations()) {
    EXPECT_EQ(asked.formulation_named(asked.name_of(formulation)), formulation);
  }
  EXPECT_EQ(asked.formulation_named(""), Formulation{});
  EXPECT_EQ(complaint_of([&] { return asked.formulation_named("surogate"); }),
            "surogate: parabola has no such formulation; did you mean surrogate or "
            "penalised-surrogate?");
}

TEST(Problem, IsShownInItsFormulationsAndJudgedByOneTrueValues) {
  const Problem asked = formulable(true, true);
  const Vector outside = Vector::Constant(2, 0.25);
  const auto shown = [&](const Formulation& formulation) {
    return asked.formulated(formulation).evaluate(outside);
  };
  EXPECT_EQ(shown({}).objective, 0);
  EXPECT_EQ(shown({}).constraints, Vector::Constant(1, 0.5));
  EXPECT_EQ(shown({0, true}).objective, 10 * 0.5);
  EXPECT_EQ(shown({0, true}).constraints.size(), 0);
  EXPECT_EQ(shown({0.125}).objective, 0.125);
  EXPECT_EQ(shown({0.125, true}).objective, 0.125 + 10 * 0.5);
  for (const Formulation& formulation : asked.formulations()) {
    const Problem problem = asked.formulated(formulation);
    EXPECT_EQ(problem.name, asked.name);
    EXPECT_EQ(true_values_at(problem, outside).objective, 0);
    EXPECT_EQ(true_values_at(problem, outside).violation, 0.5);
  }
  EXPECT_THROW(formulable(true, false).formulated({0.25}), std::invalid_argument);
  EXPECT_THROW(formulable(false, true).formulated({0, true}), std::invalid_argument);
}

/// x0^2 + x1 subject to 1 - x0^2 x1 <= 0 and x1^2 - 2 <= 0.
Problem constrained() {
  Problem problem = box_problem("constrained", 2, -5, 5, 0, [](const Vector&) { return 0.0; });
  problem.constraints = 2;
  problem.best_known = -4.0;
  problem.evaluate = [](const Vector& x) {
    return Values{x[0] * x[0] + x[1], Vector{{1 - x[0] * x[0] * x[1], x[1] * x[1] - 2}}};
  };
  problem.differentiate = [evaluate = problem.evaluate](const Vector& x) {
    return Derivatives{evaluate(x), Vector{{2 * x[0], 1.0}},
                       Matrix{{-2 * x[0] * x[1], -x[0] * x[0]}, {0.0, 2 * x[1]}}};
  };
  problem.lagrangian_hessian = [](const Vector& x, double factor, const Vector& multipliers) {
    const double mixed = -2 * x[0] * multipliers[0];
    return Matrix{{2 * factor - 2 * x[1] * multipliers[0], mixed}, {mixed, 2 * multipliers[1]}};
  };
  return problem;
}

TEST(Penalty, AddsTheWeightedSumOfTheViolationsAndIsJudgedByThem) {
  const Problem problem = penalised(constrained(), 10);
  EXPECT_EQ(problem.constraints, 0);
  EXPECT_EQ(problem.best_known, -4.0);
  EXPECT_EQ(problem.evaluate(Vector{{2.0, 1.0}}).objective, 5.0) << "where the constraints hold";
  EXPECT_EQ(problem.evaluate(Vector{{2.0, 1.0}}).constraints.size(), 0);
  EXPECT_EQ(problem.evaluate(Vector{{0.5, 2.0}}).objective, 2.25 + 10 * (0.5 + 2.0));
  EXPECT_EQ(problem.true_values(Vector{{0.5, 2.0}}).objective, 2.25);
  EXPECT_EQ(problem.true_values(Vector{{0.5, 2.0}}).violation, 2.0);
}

TEST(Penalty, HasTheDerivativesOfItsValuesAndNoResiduals) {
  Problem original = constrained();
  for (const Eigen::Index equalities : {0, 1}) {
    original.equalities = equalities;
    const Problem problem = penalised(original, 10);
    for (const Vector& x : {Vector{{2.0, 1.0}}, Vector{{-1.0, 4.0}}, Vector{{0.5, 0.3}}}) {
      const Derivatives d = problem.differentiate(x);
      EXPECT_EQ(d.values.objective, problem.evaluate(x).objective);
      for (Eigen::Index i = 0; i < 2; ++i) {
        const auto along = [&](double t) {
          return problem.evaluate(x + (t - x[i]) * Vector::Unit(2, i)).objective;
        };
        EXPECT_NEAR(d.gradient[i], difference(along, x[i], 1e-3).slope, 1e-8);
      }
      EXPECT_EQ(expect_hessian_of_gradients(problem, x, 0.7, Vector()), 4);
    }
  }
  original.residuals = [](const Vector&) { return Residuals{Vector::Ones(1), Matrix::Ones(1, 2)}; };
  EXPECT_FALSE(penalised(original, 10).residuals);
  original.lagrangian_hessian = nullptr;
  EXPECT_FALSE(penalised(original, 10).lagrangian_hessian);
}

TEST(Penalty, ChargesAnEquationForEitherSign) {
  Problem original = constrained();
  original.equalities = 1;  // x0^2 x1 = 1
  const Problem problem = penalised(original, 10);
  EXPECT_EQ(problem.equalities, 0);
  EXPECT_EQ(problem.evaluate(Vector{{-1.0, 4.0}}).objective, 5.0 + 10 * (3.0 + 14.0));
  EXPECT_EQ(problem.evaluate(Vector{{0.5, 2.0}}).objective, 2.25 + 10 * (0.5 + 2.0));
  EXPECT_EQ(problem.true_values(Vector{{3.0, 1.0}}).violation, 8.0);
}

TEST(Penalty, KeepsTheSmoothingAndTrueValuesOfTheProblemsOwn) {
  Problem original = constrained();
  original.smoothed = [original](double smoothing) {
    Problem smooth = original;
    smooth.evaluate = [smoothing](const Vector&) {
      return Values{1.0, Vector::Constant(1, smoothing)};
    };
    return smooth;
  };
  original.true_values = [](const Vector&) { return TrueValues{7.0, 3.0}; };
  const Problem problem = penalised(original, 10);
  EXPECT_EQ(problem.smoothed(0.5).evaluate(Vector::Zero(2)).objective, 6.0);
  EXPECT_EQ(problem.true_values(Vector::Zero(2)).objective, 7.0);
}

using Constraints = Capabilities::Constraints;
using Order = Capabilities::Order;

TEST(Capabilities, AcceptTheConstraintsThatTheyName) {
  // Of no constraints, an inequality, an equality, both.
  const auto accepted = [](Constraints constraints, bool needed) {
    std::vector<bool> all;
    for (const auto& [inequalities, equalities] : {std::pair(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
      Problem problem = parabola(2);
      problem.equalities = equalities;
      problem.constraints = equalities + inequalities;
      all.push_back(
          Capabilities{.constraints = constraints, .needs_constraints = needed}.accept(problem));
    }
    return all;
  };
  EXPECT_THAT(accepted(Constraints::none, false), ElementsAre(true, false, false, false));
  EXPECT_THAT(accepted(Constraints::inequalities, false), ElementsAre(true, true, false, false));
  EXPECT_THAT(accepted(Constraints::all, false), ElementsAre(true, true, true, true));
  EXPECT_THAT(accepted(Constraints::inequalities, true), ElementsAre(false, true, false, false));
  EXPECT_THAT(accepted(Constraints::all, true), ElementsAre(false, true, true, true));
}

TEST(Capabilities, AcceptTheirNumbersOfVariablesAndNoBoxOfASinglePoint) {
  const Capabilities two_to_four = {.least_variables = 2, .most_variables = 4};
  for (const Eigen::Index n : {1, 2, 3, 4, 5}) {
    EXPECT_EQ(two_to_four.accept(parabola(n)), n >= 2 && n <= 4) << n;
    EXPECT_TRUE(Capabilities().accept(parabola(n))) << n;
  }
  Problem problem = parabola(2);
  problem.lower[0] = problem.upper[0];
  EXPECT_TRUE(Capabilities().accept(problem));
  problem.lower = problem.upper;
  EXPECT_FALSE(Capabilities().accept(problem));
}

TEST(Capabilities, AcceptOnlyWhatHasAllThatTheyNeed) {
  Problem full = with_idle_knob(parabola(2));
  curve_by(full, constant_hessian(2, 2));
  Problem bare = parabola(2);
  bare.differentiate = nullptr;
  bare.residuals = nullptr;
  Problem without_gradient = full;
  without_gradient.differentiate = nullptr;
  for (const Capabilities& each :
       {Capabilities{.derivatives = Order::gradient}, Capabilities{.derivatives = Order::hessian},
        Capabilities{.needs_residuals = true}, Capabilities{.needs_smoothing = true}}) {
    EXPECT_TRUE(each.accept(full)) << each.needs_in_words();
    EXPECT_FALSE(each.accept(bare)) << each.needs_in_words();
  }
  EXPECT_FALSE(Capabilities{.derivatives = Order::hessian}.accept(parabola(2)));
  EXPECT_FALSE(Capabilities{.derivatives = Order::hessian}.accept(without_gradient));
  EXPECT_TRUE(Capabilities().accept(bare));
}

TEST(Capabilities, AreSaidInWords) {
  const auto variables = [](Eigen::Index least, Eigen::Index most) {
    return Capabilities{.least_variables = least, .most_variables = most}.variables_in_words();
  };
  EXPECT_EQ(variables(1, Capabilities::any_number), "any number");
  EXPECT_EQ(variables(2, Capabilities::any_number), "2 or more");
  EXPECT_EQ(variables(1, 8), "up to 8");
  EXPECT_EQ(variables(2, 8), "2 to 8");
  EXPECT_EQ(variables(1, 1), "1");
  const auto constraints = [](Constraints kind, bool needed) {
    return Capabilities{.constraints = kind, .needs_constraints = needed}.constraints_in_words();
  };
  EXPECT_EQ(constraints(Constraints::none, false), "none");
  EXPECT_EQ(constraints(Constraints::inequalities, false), "inequalities");
  EXPECT_EQ(constraints(Constraints::inequalities, true), "needs inequalities");
  EXPECT_EQ(constraints(Constraints::all, false), "all");
  EXPECT_EQ(constraints(Constraints::all, true), "needs some");
  EXPECT_EQ(Capabilities().needs_in_words(), "nothing");
  EXPECT_EQ((Capabilities{.derivatives = Order::hessian}).needs_in_words(), "Hessians");
  EXPECT_EQ((Capabilities{.needs_residuals = true}).needs_in_words(), "residuals");
  EXPECT_EQ(
      (Capabilities{.derivatives = Order::gradient, .needs_smoothing = true}).needs_in_words(),
      "gradients, smoothing");
}

}  // namespace
}  // namespace ricochet
