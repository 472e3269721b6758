#include <gtest/gtest.h>

#include <cmath>

#include "src/studies/problems/problems.h"

namespace ricochet::studies::problems {
namespace {

/// floor(10 x) / 10 on [0, 1], where the last tenth of y is infeasible.
Problem stairs() {
  Problem problem;
  problem.name = "stairs";
  problem.lower = Vector::Zero(2);
  problem.upper = problem.start = Vector::Ones(2);
  problem.tolerance = 0.01;
  problem.best_known = 0;
  problem.evaluate = [](const Vector& x) { return Values{std::floor(10 * x[0]) / 10, {}}; };
  return problem;
}

TEST(Difficulty, IsTheShareOfTheBoxThatSolvesAProblem) {
  const Difficulty difficulty = difficulty_of(stairs(), 20'000).value();
  EXPECT_NEAR(difficulty.solving_share, 0.1, 0.01);
  EXPECT_LT(difficulty.interval.lower, 0.1);
  EXPECT_GT(difficulty.interval.upper, 0.1);
  EXPECT_DOUBLE_EQ(difficulty.random_search.value(), 1 / difficulty.solving_share);
  EXPECT_EQ(difficulty.feasible_share, 1);
}

TEST(Difficulty, CountsFeasiblePointsOnly) {
  Problem problem = stairs();
  problem.constraints = 1;
  problem.evaluate = [](const Vector& x) {
    return Values{std::floor(10 * x[0]) / 10, Vector::Constant(1, x[1] - 0.75)};
  };
  const Difficulty difficulty = difficulty_of(problem, 20'000).value();
  EXPECT_NEAR(difficulty.feasible_share, 0.75, 0.02);
  EXPECT_NEAR(difficulty.solving_share, 0.075, 0.01);
}

TEST(Difficulty, KnowsHowWideAPlateauIs) {
  Problem problem = stairs();
  problem.lower = problem.upper = problem.start = Vector::Zero(1);
  problem.upper = Vector::Constant(1, 1);
  // From a point of a stair to its end, and up to twice that.
  const double stair = difficulty_of(problem, 20'000).value().plateau;
  EXPECT_GT(stair, 0.03);
  EXPECT_LT(stair, 0.1);
  problem.evaluate = [](const Vector& x) { return Values{x[0], {}}; };
  EXPECT_LT(difficulty_of(problem, 1000).value().plateau, 2e-6);
  problem.evaluate = [](const Vector&) { return Values{0, {}}; };
  EXPECT_GE(difficulty_of(problem, 1000).value().plateau, 0.5);
}

TEST(Difficulty, IsUnknownWithoutABestValueAndBoundedWithoutASolution) {
  Problem problem = stairs();
  problem.best_known = -1;
  const Difficulty difficulty = difficulty_of(problem, 1000).value();
  EXPECT_EQ(difficulty.solving_share, 0);
  EXPECT_FALSE(difficulty.random_search);
  EXPECT_NEAR(difficulty.interval.upper, 0.0038, 1e-4);
  problem.best_known.reset();
  EXPECT_FALSE(difficulty_of(problem, 10));
}

TEST(Difficulty, IsTheSameAgain) {
  EXPECT_EQ(difficulty_of(stairs(), 500)->solving_share,
            difficulty_of(stairs(), 500)->solving_share);
}

}  // namespace
}  // namespace ricochet::studies::problems
