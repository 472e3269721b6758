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

TEST(Problem, IsViolatedByItsLargestConstraintAndAnEqualityOfEitherSignBeyondOneTolerance) {
  const auto violation = [](const Vector& constraints, Eigen::Index equalities) {
    return true_values_of({0, constraints}, equalities).violation;
  };
  EXPECT_EQ(violation(Vector(0), 0), 0);
  EXPECT_EQ(violation(Vector{{-3, 2, 1}}, 0), 2);
  EXPECT_EQ(violation(Vector{{-1, 4}}, 1), 4);
  constexpr double eps = constraint_tolerance;
  for (const double size : {eps, 2 * eps, 3.0}) {
    const double beyond = size == eps ? 0 : size;
    for (const Eigen::Index equalities : {0, 1, 2}) {
      EXPECT_EQ(violation(Vector{{size, 0}}, equalities), beyond);
      EXPECT_EQ(violation(Vector{{0, size}}, equalities), beyond);
      EXPECT_EQ(violation(Vector{{-size, 0}}, equalities), equalities > 0 ? beyond : 0);
      EXPECT_EQ(violation(Vector{{0, -size}}, equalities), equalities > 1 ? beyond : 0);
      EXPECT_TRUE(std::isnan(violation(Vector{{quiet_nan, size}}, equalities)));
      EXPECT_TRUE(std::isnan(violation(Vector{{size, quiet_nan}}, equalities)));
    }
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

TEST(Problem, HasTheFormulationsThatItsConstraintsAndItsKnobAllow) {
  const auto names = [](const Problem& problem, const std::vector<double>& smoothings = {}) {
    std::vector<std::string> all;
    for (const Formulation& formulation : problem.formulations(smoothings)) {
      all.push_back(problem.name_of(formulation));
      if (!smoothings.empty()) continue;  // those of a plan have no name of their own
      EXPECT_EQ(problem.formulation_named(all.back()), formulation);
    }
    return all;
  };
  EXPECT_THAT(names(formulable(false, false)), ElementsAre("original"));
  EXPECT_THAT(names(formulable(true, false), {0.1}), ElementsAre("original", "penalised"));
  EXPECT_THAT(names(formulable(false, true)), ElementsAre("count", "surrogate"));
  const Problem both = formulable(true, true);
  EXPECT_THAT(names(both),
              ElementsAre("count", "penalised-count", "surrogate", "penalised-surrogate"));
  EXPECT_THAT(names(both, {0.1, both.smoothing}),
              ElementsAre("count", "penalised-count", "surrogate", "penalised-surrogate",
                          "surrogate-0.1", "penalised-surrogate-0.1"))
      << "every smoothing once";
  EXPECT_EQ(both.formulation_named(""), Formulation{});
  EXPECT_EQ(complaint_of([&] { return both.formulation_named("surogate"); }),
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
    EXPECT_THAT(true_values_at(problem, outside), FieldsAre(0, 0.5));
  }
  EXPECT_THROW(formulable(true, false).formulated({0.25}), std::invalid_argument);
  EXPECT_THROW(formulable(false, true).formulated({0, true}), std::invalid_argument);
}

TEST(Penalty, AddsTheWeightedSumOfTheViolationsAndIsJudgedByThem) {
  Problem original = constrained();
  const Vector kept{{2.0, 1.0}}, violated{{0.5, 2.0}}, below{{-1.0, 4.0}};
  for (const Eigen::Index equalities : {0, 1}) {  // an equation is charged for either sign
    original.equalities = equalities;
    const double charged = equalities == 1 ? 1 : 0;  // where it is negative
    const Problem problem = penalised(original, 10);
    EXPECT_EQ(std::tuple(problem.constraints, problem.equalities, problem.best_known),
              std::tuple(0, 0, -4.0));
    EXPECT_EQ(problem.evaluate(kept).objective, 5.0 + 10 * charged * 3.0);
    EXPECT_EQ(problem.evaluate(kept).constraints.size(), 0);
    EXPECT_EQ(problem.evaluate(violated).objective, 2.25 + 10 * (0.5 + 2.0));
    EXPECT_EQ(problem.evaluate(below).objective, 5.0 + 10 * (charged * 3.0 + 14.0));
    EXPECT_THAT(problem.true_values(violated), FieldsAre(2.25, 2.0));
    EXPECT_THAT(problem.true_values(Vector{{3.0, 1.0}}), FieldsAre(10.0, charged * 8.0));
  }
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

TEST(Penalty, KeepsTheSmoothingAndTrueValuesOfTheProblemsOwn) {
  Problem original = formulable(true, true);
  original.true_values = [](const Vector&) { return TrueValues{7.0, 3.0}; };
  const Problem problem = penalised(original, 10);
  EXPECT_EQ(problem.smoothed(0.125).evaluate(Vector::Constant(2, 0.25)).objective,
            0.125 + 10 * 0.5);
  EXPECT_EQ(problem.true_values(Vector::Zero(2)).objective, 7.0);
}

using Constraints = Capabilities::Constraints;
using Order = Capabilities::Order;

TEST(Capabilities, AcceptTheConstraintsThatTheyName) {
  struct Kind {
    Constraints constraints;
    bool needed;
    std::array<bool, 4> accepted;  ///< of no constraints, an inequality, an equality, both
    std::string in_words;
  };
  for (const auto& [constraints, needed, accepted, in_words] :
       {Kind{Constraints::none, false, {true, false, false, false}, "none"},
        Kind{Constraints::inequalities, false, {true, true, false, false}, "inequalities"},
        Kind{Constraints::all, false, {true, true, true, true}, "all"},
        Kind{Constraints::inequalities, true, {false, true, false, false}, "needs inequalities"},
        Kind{Constraints::all, true, {false, true, true, true}, "needs some"}}) {
    const Capabilities each{.constraints = constraints, .needs_constraints = needed};
    EXPECT_EQ(each.constraints_in_words(), in_words);
    for (const std::size_t k : {0, 1, 2, 3}) {
      Problem problem = parabola(2);
      problem.equalities = k < 2 ? 0 : 1;
      problem.constraints = problem.equalities + (k % 2 == 0 ? 0 : 1);
      EXPECT_EQ(each.accept(problem), accepted[k]) << in_words << " " << k;
    }
  }
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
  EXPECT_EQ(Capabilities().needs_in_words(), "nothing");
  EXPECT_EQ((Capabilities{.derivatives = Order::hessian}).needs_in_words(), "Hessians");
  EXPECT_EQ((Capabilities{.needs_residuals = true}).needs_in_words(), "residuals");
  EXPECT_EQ(
      (Capabilities{.derivatives = Order::gradient, .needs_smoothing = true}).needs_in_words(),
      "gradients, smoothing");
}

}  // namespace
}  // namespace ricochet
