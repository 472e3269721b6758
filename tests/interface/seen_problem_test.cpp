#include "src/core/seen_problem.h"

#include "tests/support/numbers.h"
#include "tests/support/test.h"

namespace ricochet::interface {
namespace {

using testing::ElementsAre;

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

/// A problem, and how it is seen.
struct Sight {
  explicit Sight(Problem asked, std::int64_t evaluations = 100)
      : problem(std::move(asked)),
        evaluator(problem, Budget{evaluations}),
        view(evaluator, problem.start, random) {}

  std::int64_t charged() { return evaluator.ledger().charged; }

  int values(const std::array<double, 2>& x, double* objective, double* constraints = nullptr) {
    return seen->values(seen, x.data(), objective, constraints);
  }

  Problem problem;
  Evaluator evaluator;
  Random random{7};
  SeenProblem view;
  ricochet_problem* const seen = &view;
};

TEST(SeenProblem, SaysWhatItIs) {
  const Sight sight(product());
  const ricochet_problem& seen = *sight.seen;
  EXPECT_THAT((std::vector{seen.abi, seen.dimension, seen.constraints, seen.equalities,
                           seen.has_derivatives, seen.has_residuals}),
              ElementsAre(RICOCHET_ABI, 2, 3, 1, 1, 0));
  EXPECT_STREQ(seen.name, "product");
  EXPECT_THAT((std::vector{seen.lower[1], seen.upper[1], seen.start[0], seen.start[1]}),
              ElementsAre(-2, 2, 0.5, 1.5));
  Problem without = product();
  without.differentiate = nullptr;
  EXPECT_EQ(Sight(without).seen->has_derivatives, 0);
  EXPECT_EQ(Sight(squares()).seen->has_residuals, 1);
}

TEST(SeenProblem, TellsValuesAndDerivativesRowByRow) {
  Sight sight(product());
  ricochet_problem* const seen = sight.seen;
  const std::array<double, 2> x = {0.25, 2};
  double objective = 0;
  std::array<double, 3> constraints{};
  ASSERT_EQ(sight.values(x, &objective, constraints.data()), 0);
  EXPECT_EQ(objective, 0.5);
  EXPECT_THAT(constraints, ElementsAre(1.25, 0.0625 - 2, -2));
  EXPECT_EQ(seen->remaining(seen), 99);

  std::array<double, 2> gradient{};
  std::array<double, 6> jacobian{};
  ASSERT_EQ(seen->derivatives(seen, x.data(), &objective, constraints.data(), gradient.data(),
                              jacobian.data()),
            0);
  EXPECT_THAT(gradient, ElementsAre(2, 0.25));
  EXPECT_THAT(jacobian, ElementsAre(1, 1, 0.5, -1, 0, -1));
  EXPECT_EQ(seen->remaining(seen), 97) << "the values were known";
}

TEST(SeenProblem, ChargesOnceWhoAsksForPartsOfOnePoint) {
  Sight sight(product());
  ricochet_problem* const seen = sight.seen;
  const std::array<double, 2> x = {0.25, 1};
  double objective = 0;
  std::array<double, 6> many{};
  EXPECT_EQ(sight.values(x, &objective), 0);
  EXPECT_EQ(sight.values(x, nullptr, many.data()), 0);
  EXPECT_EQ(sight.charged(), 1);
  EXPECT_EQ(seen->derivatives(seen, x.data(), nullptr, nullptr, many.data(), nullptr), 0);
  EXPECT_EQ(seen->derivatives(seen, x.data(), nullptr, nullptr, nullptr, many.data()), 0);
  EXPECT_EQ(sight.charged(), 3);
  EXPECT_EQ(sight.values(x, &objective), 0);
  EXPECT_EQ(sight.charged(), 4) << "asked for the second time";
}

TEST(SeenProblem, TellsResidualsAndTheirJacobianRowByRow) {
  Sight sight(squares(), 6);
  ricochet_problem* const seen = sight.seen;
  const std::array<double, 2> x = {0.25, 2}, y = {1, 1};
  std::array<double, 3> residuals{};
  std::array<double, 6> jacobian{};
  EXPECT_EQ(seen->residual_count(seen, x.data()), 3);
  ASSERT_EQ(seen->residuals(seen, x.data(), residuals.data(), nullptr), 0);
  EXPECT_EQ(sight.charged(), 1);
  EXPECT_THAT(residuals, ElementsAre(2.25, -1.75, 0));
  ASSERT_EQ(seen->residuals(seen, x.data(), nullptr, jacobian.data()), 0);
  EXPECT_EQ(sight.charged(), 3);
  EXPECT_THAT(jacobian, ElementsAre(1, 1, 1, -1, 0, 0));
  ASSERT_EQ(seen->residuals(seen, y.data(), residuals.data(), jacobian.data()), 0);
  EXPECT_EQ(sight.charged(), 6);
  EXPECT_EQ(residuals[0], 2);
  EXPECT_EQ(seen->residuals(seen, x.data(), residuals.data(), nullptr), 1) << "all is spent";
  EXPECT_EQ(residuals[0], 2);
  EXPECT_EQ(seen->residual_count(seen, x.data()), 3) << "it is known";
}

TEST(SeenProblem, RefusesOnceTheBudgetIsSpentAndWritesNothing) {
  Sight sight(product(), 2);
  ricochet_problem* const seen = sight.seen;
  double objective = 0;
  for (const double x : {0, 1}) EXPECT_EQ(sight.values({x, 0}, &objective), 0);
  EXPECT_EQ(seen->remaining(seen), 0);
  objective = 42;
  EXPECT_EQ(sight.values({0.5, 0}, &objective), 1);
  EXPECT_EQ(seen->derivatives(seen, seen->start, &objective, nullptr, nullptr, nullptr), 1);
  EXPECT_EQ(objective, 42);
  EXPECT_EQ(sight.evaluator.termination_reason(), TerminationReason::evaluations);
}

TEST(SeenProblem, RefusesAPointThatIsNone) {
  Sight sight(product());
  double objective = 0;
  EXPECT_EQ(sight.seen->values(sight.seen, nullptr, &objective, nullptr), 1);
  EXPECT_THROW(std::rethrow_exception(sight.view.failure()), std::invalid_argument);
  EXPECT_FALSE(sight.evaluator.over());
  EXPECT_EQ(sight.values({0, infinity}, &objective), 1);
  EXPECT_EQ(sight.evaluator.termination_reason(), TerminationReason::bad_point);
}

TEST(SeenProblem, ThrowsNothing) {
  Problem problem = product();
  problem.evaluate = [](const Vector&) -> Values { throw std::runtime_error("broken"); };
  Sight sight(problem);
  double objective = 0;
  EXPECT_EQ(sight.values({0.5, 1.5}, &objective), 1);
  EXPECT_TRUE(sight.evaluator.failure());
  EXPECT_FALSE(sight.view.failure());
}

TEST(SeenProblem, DrawsFromTheRunsOwnRandomness) {
  Sight sight(product());
  Random same(7);
  for (int k = 0; k < 10; ++k) EXPECT_EQ(sight.seen->uniform(sight.seen), uniform(same));
}

}  // namespace
}  // namespace ricochet::interface
