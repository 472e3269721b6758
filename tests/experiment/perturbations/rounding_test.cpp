#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "src/experiment/perturbations.h"
#include "tests/experiment/perturbations/random_problem.h"

namespace ricochet {
namespace {

/// By the C library.
double six_digits(double number) {
  char text[64];
  std::snprintf(text, sizeof text, "%.6g", number);
  return std::strtod(text, nullptr);
}

Matrix six_digits(const Matrix& numbers) {
  return numbers.unaryExpr([](double number) { return six_digits(number); });
}

TEST(Truncated, KeepsSixDigitsOfWhateverIsTold) {
  Random random(2);
  for (const Problem& problem : random_problems()) {
    const Problem told = truncated().perturbed(problem, 0);
    for (int k = 0; k < 20; ++k) {
      const Vector x = uniform_point(problem, random);
      const Derivatives d = problem.differentiate(x);
      EXPECT_EQ(told.evaluate(x).objective, six_digits(d.values.objective));
      EXPECT_EQ(told.evaluate(x).constraints, six_digits(d.values.constraints));
      EXPECT_EQ(told.differentiate(x).gradient, six_digits(d.gradient));
      EXPECT_EQ(told.differentiate(x).jacobian, six_digits(d.jacobian));
      EXPECT_EQ(told.residuals(x).values, six_digits(problem.residuals(x).values));
      EXPECT_EQ(told.residuals(x).jacobian, six_digits(problem.residuals(x).jacobian));
      const Vector multipliers = normal(problem.constraints, random);
      EXPECT_EQ(told.lagrangian_hessian(x, 1, multipliers),
                six_digits(problem.lagrangian_hessian(x, 1, multipliers)));
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
      const Vector at =
          problem.lower.array() +
          notch.array() *
              (1000 * Vector::NullaryExpr(notch.size(), [&] { return uniform(random); }).array())
                  .round();
      const Vector aside =
          at.array() + 0.49 * notch.array() * (normal(notch.size(), random).array().sin());
      const Vector x = aside.cwiseMax(problem.lower).cwiseMin(problem.upper);
      const Derivatives there = problem.differentiate(at);
      const Derivatives d = told.differentiate(x);
      EXPECT_NEAR(told.evaluate(x).objective, there.values.objective, 1e-11);
      EXPECT_LE((d.gradient - there.gradient).norm(), 1e-11 * (1 + there.gradient.norm()));
      EXPECT_LE((d.jacobian - there.jacobian).norm(), 1e-11 * (1 + there.jacobian.norm()));
      EXPECT_NEAR(told.residuals(x).values[0], problem.residuals(at).values[0], 1e-11);
      const Vector multipliers = Vector::Ones(problem.constraints);
      EXPECT_NEAR(told.lagrangian_hessian(x, 1, multipliers)(0, 0),
                  problem.lagrangian_hessian(at, 1, multipliers)(0, 0), 1e-10);
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

}  // namespace
}  // namespace ricochet
