// Perturbations of the values without noise: rounding, constraints, failures.

#include "ricochet/evaluator.h"
#include "src/core/evaluator.h"
#include "src/core/time_limit.h"
#include "src/experiment/perturbations.h"
#include "tests/core/hessian_check.h"
#include "tests/experiment/perturbations/random_problem.h"

namespace ricochet {
namespace {

/// By the C library.
double six_digits(double number) {
  char text[64];
  std::snprintf(text, sizeof text, "%.6g", number);
  return std::strtod(text, nullptr);
}

TEST(Truncated, KeepsSixDigitsOfWhateverIsTold) {
  Random random(2);
  for (const Problem& problem : random_problems()) {
    const Problem told = truncated().perturbed(problem, 0);
    for (int k = 0; k < 20; ++k) {
      const Vector x = uniform_point(problem, random);
      const Vector multipliers = normal(problem.constraints, random);
      std::vector<double> expected = told_at(problem, x, 1, multipliers).numbers();
      for (double& number : expected) number = six_digits(number);
      EXPECT_EQ(told_at(told, x, 1, multipliers).numbers(), expected);
      EXPECT_EQ(told.evaluate(x), told.differentiate(x).values);
    }
  }
}

TEST(Truncated, ManagesNumbersOfEverySize) {
  Problem problem = random_problems().front();
  double value = 0;
  problem.evaluate = [&value](const Vector&) { return Values{value, {}}; };
  const Problem told = truncated().perturbed(problem, 0);
  for (int exponent = -323; exponent <= 308; ++exponent) {
    value = -1.2345675 * std::pow(10.0, exponent);
    EXPECT_EQ(told.evaluate(problem.start).objective, six_digits(value));
  }
  for (const double same : {0.0, 7.0, -123456.0, HUGE_VAL, -HUGE_VAL}) {
    value = same;
    EXPECT_EQ(told.evaluate(problem.start).objective, same);
  }
  value = std::nan("");
  EXPECT_TRUE(std::isnan(told.evaluate(problem.start).objective));
}

TEST(Quantised, EvaluatesEverythingAtTheNextNotch) {
  Random random(3);
  for (const Problem& problem : random_problems()) {
    const Problem told = quantised().perturbed(problem, 0);
    const Vector notch = 1e-3 * (problem.upper - problem.lower);
    for (int k = 0; k < 20; ++k) {
      const Vector notches = (uniform_point(problem, random) - problem.lower).cwiseQuotient(notch);
      const Vector at = problem.lower.array() + notch.array() * notches.array().round();
      const Vector aside = 0.49 * normal(notch.size(), random).array().sin() * notch.array();
      const Vector x = (at + aside).cwiseMax(problem.lower).cwiseMin(problem.upper);
      const std::vector<double> there = told_at(problem, at).numbers();
      const std::vector<double> here = told_at(told, x).numbers();
      ASSERT_EQ(here.size(), there.size());
      for (std::size_t i = 0; i < here.size(); ++i) {
        EXPECT_NEAR(here[i], there[i], 1e-11 * (1 + std::abs(there[i])));
      }
      EXPECT_NEAR(told.evaluate(x).objective, problem.evaluate(at).objective, 1e-11);
      EXPECT_EQ(told.true_values(x).objective, true_values_at(problem, x).objective);
    }
  }
}

TEST(Quantised, IsAStaircaseOfAThousandAndOneStepsWithinTheBox) {
  Random random(4);
  Problem problem = random_problem(random, {.dimension = 1});
  std::vector<double> asked;
  problem.evaluate = [&](const Vector& x) {
    if (asked.empty() || asked.back() != x[0]) asked.push_back(x[0]);
    return Values{x[0], {}};
  };
  const Problem told = quantised().perturbed(problem, 0);
  for (int k = 0; k <= 100'000; ++k) {
    told.evaluate(problem.lower + 1e-5 * k * (problem.upper - problem.lower));
  }
  EXPECT_EQ(asked.size(), 1001U);
  EXPECT_EQ(asked.front(), problem.lower[0]);
  EXPECT_LE(asked.back(), problem.upper[0]);
  EXPECT_NEAR(asked.back(), problem.upper[0], 1e-15);
}

TEST(BinaryConstraints, AnswerWhetherAConstraintHoldsWithoutSlopesAndCurvature) {
  Random random(1);
  int held = 0, broken = 0;
  for (const Problem& problem : random_problems()) {
    const Perturbation perturbation = binary_constraints();
    EXPECT_EQ(perturbation.applies(problem), problem.constraints > 0);
    if (!perturbation.applies(problem)) continue;
    const Problem told = perturbation.perturbed(problem, 0);
    for (int k = 0; k < 20; ++k) {
      const Vector x = k == 0 ? *problem.best_point : uniform_point(problem, random);
      const Values own = problem.evaluate(x);
      const Values values = told.evaluate(x);
      EXPECT_EQ(values.objective, own.objective);
      for (Eigen::Index j = 0; j < problem.constraints; ++j) {
        const double value = own.constraints[j];
        const bool holds = (j < problem.equalities ? std::abs(value) : value) <= 1e-6;
        EXPECT_EQ(values.constraints[j], holds ? 0 : 1);
        ++(holds ? held : broken);
      }
      const bool feasible = true_values_at(problem, x).violation == 0;
      EXPECT_EQ(true_values_of(values, problem.equalities).violation == 0, feasible);
      Told expected = told_at(problem, x, 0.7, Vector::Zero(problem.constraints));
      expected.constraints = values.constraints;
      expected.jacobian.setZero();
      EXPECT_EQ(told_at(told, x, 0.7, normal(problem.constraints, random)), expected);
    }
    EXPECT_GT(
        expect_hessian_of_gradients(told, problem.start, 0.7, normal(problem.constraints, random)),
        0);
  }
  EXPECT_GT(held, 50);
  EXPECT_GT(broken, 50);
}

TEST(BinaryConstraints, AllowEveryConstraintItsToleranceAndTakeWhatIsNoNumberForBroken) {
  Problem problem = random_problems().front();
  problem.constraints = 8;
  problem.equalities = 5;
  const Vector values{{9e-7, -9e-7, 1.1e-6, -1.1e-6, std::nan(""), 9e-7, 1.1e-6, std::nan("")}};
  problem.evaluate = [&](const Vector&) { return Values{0, values}; };
  const Problem told = binary_constraints().perturbed(problem, 0);
  EXPECT_EQ(told.evaluate(problem.start).constraints,
            (Vector{{0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 1.0, 1.0}}));
}

TEST(InfiniteWhereInfeasible, IsInfiniteWhereAnInequalityIsBrokenAndNowhereElse) {
  Random random(2);
  int inside = 0, outside = 0;
  for (const Problem& problem : random_problems()) {
    const Perturbation perturbation = infinite_where_infeasible();
    EXPECT_EQ(perturbation.applies(problem), problem.constraints > problem.equalities);
    if (!perturbation.applies(problem)) continue;
    const Problem told = perturbation.perturbed(problem, 0);
    const Vector multipliers = normal(problem.constraints, random);
    for (int k = 0; k < 20; ++k) {
      const Vector x = k == 0 ? *problem.best_point : uniform_point(problem, random);
      const Told own = told_at(problem, x, 1, multipliers);
      const Told shown = told_at(told, x, 1, multipliers);
      EXPECT_EQ(told.evaluate(x).objective, shown.objective);
      EXPECT_EQ(shown.constraints, own.constraints);
      EXPECT_EQ(shown.jacobian, own.jacobian);
      EXPECT_EQ(told.true_values(x).objective, own.objective);
      const Eigen::Index inequalities = problem.constraints - problem.equalities;
      if (own.constraints.tail(inequalities).maxCoeff() <= 0) {
        ++inside;
        EXPECT_EQ(shown, own);
      } else {
        ++outside;
        EXPECT_EQ(shown.objective, HUGE_VAL);
        EXPECT_TRUE(shown.gradient.array().isNaN().all());
        EXPECT_EQ(shown.residuals.squaredNorm(), HUGE_VAL);
        EXPECT_TRUE(shown.jacobian_of_residuals.array().isNaN().all());
        EXPECT_TRUE(shown.hessian.array().isNaN().all());
        EXPECT_EQ(told.lagrangian_hessian(x, 0, multipliers),
                  problem.lagrangian_hessian(x, 0, multipliers));
      }
    }
  }
  EXPECT_GT(inside, 50);
  EXPECT_GT(outside, 50);
}

constexpr int calls = 20'000;

void expect_share(int count, double probability) {
  EXPECT_NEAR(count, probability * calls, 5 * std::sqrt(probability * (1 - probability) * calls));
}

TEST(NotANumber, IsATwentiethOfAllFunctionsEachWithItsSlopes) {
  Random random(1);
  const Problem problem = random_problem(random, {.constraints = 2});
  const Problem told = not_a_number().perturbed(problem, 1);
  const Vector& x = problem.start;
  std::array<int, 5> lost = {};
  int both = 0;
  const std::vector<double> own = told_at(problem, x, 1, Vector::Zero(2)).numbers();
  const auto expect_alike = [](const auto& numbers, double number) {
    EXPECT_EQ(numbers.array().isNaN().count(), std::isnan(number) ? numbers.size() : 0);
  };
  for (int k = 0; k < calls; ++k) {
    const Values values = told.evaluate(x);
    const Told all = told_at(told, x, 1, Vector::Zero(2));
    const double of_each[] = {values.objective, values.constraints[1], all.objective,
                              all.residuals[0], all.hessian(0, 0)};
    for (std::size_t i = 0; i < lost.size(); ++i) lost[i] += std::isnan(of_each[i]);
    both += std::isnan(values.objective) && std::isnan(values.constraints[1]);
    const std::vector<double> numbers = all.numbers();
    for (std::size_t i = 0; i < own.size(); ++i) {
      EXPECT_TRUE(std::isnan(numbers[i]) || numbers[i] == own[i]);
    }
    expect_alike(all.gradient, all.objective);
    for (Eigen::Index j = 0; j < 2; ++j) expect_alike(all.jacobian.row(j), all.constraints[j]);
    expect_alike(all.residuals, all.residuals[0]);
    expect_alike(all.jacobian_of_residuals, all.residuals[0]);
    expect_alike(all.hessian, all.hessian(0, 0));
  }
  for (const int count : lost) expect_share(count, 0.05);
  expect_share(both, 0.0025);
}

/// Calls of each kind, which expect what the problem itself tells.
std::vector<std::function<void()>> ways_to_ask(const Problem& told, const Problem& problem) {
  const Vector &x = problem.start, none = Vector::Zero(problem.constraints);
  const Matrix hessian = problem.lagrangian_hessian(x, 1, none);
  return {[=] { EXPECT_EQ(told.evaluate(x), problem.evaluate(x)); },
          [=] { EXPECT_EQ(told.differentiate(x).gradient, problem.differentiate(x).gradient); },
          [=] { EXPECT_EQ(told.residuals(x).values, problem.residuals(x).values); },
          [=] { EXPECT_EQ(told.lagrangian_hessian(x, 1, none), hessian); }};
}

TEST(Throwing, ThrowsOnceInAThousandCallsOfAnyKind) {
  Random random(1);
  const Problem problem = random_problem(random, {.constraints = 1});
  const Problem told = throwing().perturbed(problem, 3);
  for (const auto& ask : ways_to_ask(told, problem)) {
    int thrown = 0;
    for (int k = 0; k < calls; ++k) {
      try {
        ask();
      } catch (const std::runtime_error&) {
        ++thrown;
      }
    }
    expect_share(thrown, 1e-3);
  }
  for (int k = 0; k < calls; ++k) EXPECT_NO_THROW(told.true_values(problem.start));
}

TEST(Slow, TakesATenthOfAMillisecondOfProcessorTimeMore) {
  const Problem problem = random_problems().front();
  const Problem told = slow().perturbed(problem, 0);
  for (const auto& ask : ways_to_ask(told, problem)) {
    const double before = processor_seconds();
    for (int k = 0; k < 10; ++k) ask();
    EXPECT_GE(processor_seconds() - before, 1e-3);
  }
  Evaluator evaluator(told, {1'000'000, 0.01});
  while (!evaluator.over()) evaluator.values(problem.start);
  EXPECT_EQ(evaluator.termination_reason(), TerminationReason::seconds);
  EXPECT_LE(evaluator.ledger().charged, 100 + 64) << "the clock is read every 64 calls at least";
}

}  // namespace
}  // namespace ricochet
