#include "src/core/seen_problem.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <stdexcept>

namespace ricochet::interface {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// x y on [-2, 2]^2, where x + y = 1 and x^2 <= y and -y <= 0: with derivatives in closed form.
Problem product() {
  Problem problem;
  problem.name = "product";
  problem.lower = Vector::Constant(2, -2);
  problem.upper = Vector::Constant(2, 2);
  problem.start = Vector{{0.5, 1.5}};
  problem.constraints = 3;
  problem.equalities = 1;
  problem.evaluate = [](const Vector& x) {
    return Values{x[0] * x[1], Vector{{x[0] + x[1] - 1, x[0] * x[0] - x[1], -x[1]}}};
  };
  problem.differentiate = [evaluate = problem.evaluate](const Vector& x) {
    return Derivatives{evaluate(x), Vector{{x[1], x[0]}},
                       Matrix{{1.0, 1.0}, {2 * x[0], -1.0}, {0.0, -1.0}}};
  };
  return problem;
}

/// A problem, and how it is seen.
struct Sight {
  explicit Sight(Problem asked, std::int64_t evaluations = 100)
      : problem(std::move(asked)),
        evaluator(problem, Budget{evaluations}),
        seen(evaluator, problem.start, random) {}

  std::int64_t charged() { return evaluator.ledger().charged; }

  Problem problem;
  Evaluator evaluator;
  Random random{7};
  SeenProblem seen;
};

TEST(SeenProblem, SaysWhatItIs) {
  Sight sight(product());
  const ricochet_problem& seen = sight.seen;
  EXPECT_EQ(seen.abi, RICOCHET_ABI);
  EXPECT_EQ(seen.dimension, 2);
  EXPECT_EQ(seen.constraints, 3);
  EXPECT_EQ(seen.equalities, 1);
  EXPECT_EQ(seen.has_derivatives, 1);
  EXPECT_STREQ(seen.name, "product");
  EXPECT_EQ(seen.lower[1], -2);
  EXPECT_EQ(seen.upper[1], 2);
  EXPECT_EQ(seen.start[0], 0.5);
  EXPECT_EQ(seen.start[1], 1.5);
  Problem without = product();
  without.differentiate = nullptr;
  EXPECT_EQ(Sight(without).seen.has_derivatives, 0);
}

TEST(SeenProblem, TellsValuesAndDerivativesRowByRow) {
  Sight sight(product());
  ricochet_problem* const seen = &sight.seen;
  const std::array<double, 2> x = {0.25, 2};
  double objective = 0;
  std::array<double, 3> constraints{};
  ASSERT_EQ(seen->values(seen, x.data(), &objective, constraints.data()), 0);
  EXPECT_EQ(objective, 0.5);
  EXPECT_EQ(constraints, (std::array<double, 3>{1.25, 0.0625 - 2, -2}));
  EXPECT_EQ(seen->remaining(seen), 99);

  std::array<double, 2> gradient{};
  std::array<double, 6> jacobian{};
  ASSERT_EQ(seen->derivatives(seen, x.data(), &objective, constraints.data(), gradient.data(),
                              jacobian.data()),
            0);
  EXPECT_EQ(gradient, (std::array<double, 2>{2, 0.25}));
  EXPECT_EQ(jacobian, (std::array<double, 6>{1, 1, 0.5, -1, 0, -1}));
  EXPECT_EQ(seen->remaining(seen), 97) << "the values were known";
}

TEST(SeenProblem, ChargesOnceWhoAsksForPartsOfOnePoint) {
  Sight sight(product());
  ricochet_problem* const seen = &sight.seen;
  const std::array<double, 2> x = {0.25, 1};
  double objective = 0;
  std::array<double, 6> many{};
  EXPECT_EQ(seen->values(seen, x.data(), &objective, nullptr), 0);
  EXPECT_EQ(seen->values(seen, x.data(), nullptr, many.data()), 0);
  EXPECT_EQ(sight.charged(), 1);
  EXPECT_EQ(seen->derivatives(seen, x.data(), nullptr, nullptr, many.data(), nullptr), 0);
  EXPECT_EQ(seen->derivatives(seen, x.data(), nullptr, nullptr, nullptr, many.data()), 0);
  EXPECT_EQ(sight.charged(), 3);
  EXPECT_EQ(seen->values(seen, x.data(), &objective, nullptr), 0);
  EXPECT_EQ(sight.charged(), 4) << "asked for the second time";
}

/// x^2 + y^2 as half the sum of the squares of three residuals.
Problem squares() {
  Problem problem = product();
  problem.constraints = problem.equalities = 0;
  problem.residuals = [](const Vector& x) {
    return Residuals{Vector{{x[0] + x[1], x[0] - x[1], 0}},
                     Matrix{{1.0, 1.0}, {1.0, -1.0}, {0.0, 0.0}}};
  };
  return problem;
}

TEST(SeenProblem, TellsResidualsAndTheirJacobianRowByRow) {
  Sight sight(squares(), 6);
  ricochet_problem* const seen = &sight.seen;
  EXPECT_EQ(seen->has_residuals, 1);
  EXPECT_EQ(Sight(product()).seen.has_residuals, 0);
  const std::array<double, 2> x = {0.25, 2}, y = {1, 1};
  std::array<double, 3> residuals{};
  std::array<double, 6> jacobian{};
  EXPECT_EQ(seen->residual_count(seen, x.data()), 3);
  ASSERT_EQ(seen->residuals(seen, x.data(), residuals.data(), nullptr), 0);
  EXPECT_EQ(sight.charged(), 1);
  EXPECT_EQ(residuals, (std::array<double, 3>{2.25, -1.75, 0}));
  ASSERT_EQ(seen->residuals(seen, x.data(), nullptr, jacobian.data()), 0);
  EXPECT_EQ(sight.charged(), 3);
  EXPECT_EQ(jacobian, (std::array<double, 6>{1, 1, 1, -1, 0, 0}));
  ASSERT_EQ(seen->residuals(seen, y.data(), residuals.data(), jacobian.data()), 0);
  EXPECT_EQ(sight.charged(), 6);
  EXPECT_EQ(residuals[0], 2);
  EXPECT_EQ(seen->residuals(seen, x.data(), residuals.data(), nullptr), 1) << "all is spent";
  EXPECT_EQ(residuals[0], 2);
  EXPECT_EQ(seen->residual_count(seen, x.data()), 3) << "it is known";
}

TEST(SeenProblem, RefusesOnceTheBudgetIsSpentAndWritesNothing) {
  Sight sight(product(), 2);
  ricochet_problem* const seen = &sight.seen;
  std::array<double, 2> x = {0, 0};
  double objective = 0;
  for (int k = 0; k < 2; ++k) {
    x[0] = k;
    EXPECT_EQ(seen->values(seen, x.data(), &objective, nullptr), 0);
  }
  EXPECT_EQ(seen->remaining(seen), 0);
  objective = 42;
  x[0] = 0.5;
  EXPECT_EQ(seen->values(seen, x.data(), &objective, nullptr), 1);
  EXPECT_EQ(seen->derivatives(seen, x.data(), &objective, nullptr, nullptr, nullptr), 1);
  EXPECT_EQ(objective, 42);
  EXPECT_EQ(sight.evaluator.termination_reason(), TerminationReason::evaluations);
}

TEST(SeenProblem, RefusesAPointThatIsNone) {
  Sight sight(product());
  ricochet_problem* const seen = &sight.seen;
  double objective = 0;
  EXPECT_EQ(seen->values(seen, nullptr, &objective, nullptr), 1);
  EXPECT_THROW(std::rethrow_exception(sight.seen.failure()), std::invalid_argument);
  EXPECT_FALSE(sight.evaluator.over());
  const std::array<double, 2> x = {0, infinite};
  EXPECT_EQ(seen->values(seen, x.data(), &objective, nullptr), 1);
  EXPECT_EQ(sight.evaluator.termination_reason(), TerminationReason::bad_point);
}

TEST(SeenProblem, ThrowsNothing) {
  Problem problem = product();
  problem.evaluate = [](const Vector&) -> Values { throw std::runtime_error("broken"); };
  Sight sight(problem);
  ricochet_problem* const seen = &sight.seen;
  double objective = 0;
  EXPECT_EQ(seen->values(seen, seen->start, &objective, nullptr), 1);
  EXPECT_TRUE(sight.evaluator.failure());
  EXPECT_FALSE(sight.seen.failure());
}

TEST(SeenProblem, DrawsFromTheRunsOwnRandomness) {
  Sight sight(product());
  Random same(7);
  for (int k = 0; k < 10; ++k) EXPECT_EQ(sight.seen.uniform(&sight.seen), uniform(same));
}

}  // namespace
}  // namespace ricochet::interface
