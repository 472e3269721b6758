#include <gtest/gtest.h>

#include <cmath>

#include "ricochet/run.h"
#include "solvers/library_solvers.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

double end_of(const Problem& problem, std::int64_t budget) {
  return run(problem, dlib_global_search(), {budget}, 1).trace.back().true_values.objective;
}

TEST(DlibGlobalSearch, TakesFewVariablesAndNoConstraints) {
  EXPECT_TRUE(dlib_global_search().accepts(staircase()));
  EXPECT_TRUE(dlib_global_search().accepts(sphere(8, 3)));
  EXPECT_FALSE(dlib_global_search().accepts(sphere(9, 3)));
  EXPECT_FALSE(dlib_global_search().accepts(disc()));
}

TEST(DlibGlobalSearch, BeginsAtTheStart) {
  const Problem problem = sphere(3, 3);
  const RunRecord record = run(problem, dlib_global_search(), {1}, 0);
  EXPECT_LT((record.trace.front().x - problem.start).norm(), 1e-12);
}

TEST(DlibGlobalSearch, ModelsAQuadraticFunction) {
  EXPECT_LT(end_of(sphere(2, 3), 60), 1e-6);
  EXPECT_LT(end_of(sphere(5, -20), 200), 1e-6);
}

TEST(DlibGlobalSearch, FindsAnOptimumInACorner) {
  EXPECT_NEAR(end_of(sphere(2, 130), 100), 2 * 30 * 30, 1e-3);
}

TEST(DlibGlobalSearch, FindsTheLowestOfManyHollows) {
  // Rastrigin's function in one variable: 10 hollows, the lowest, 0, at the origin.
  const Problem problem = box_problem("hollows", 1, -5.12, 4.12, 3, [](const Vector& x) {
    return x[0] * x[0] + 10 * (1 - std::cos(2 * M_PI * x[0]));
  });
  EXPECT_LT(end_of(problem, 150), 1e-3);
}

TEST(DlibGlobalSearch, GoesRoundPointsWithoutNumbers) {
  EXPECT_LT(end_of(half_a_number(), 100), 1e-4);
}

TEST(DlibGlobalSearch, SaysSoWhereNoTwoValuesDiffer) {
  for (const Problem& problem : {plateau(2), never_a_number(2)}) {
    const RunRecord record = run(problem, dlib_global_search(), {1500}, 0);
    EXPECT_EQ(record.terminations.front().reason, "no two values differ");
    EXPECT_EQ(record.terminations.back().reason, "stopped by the evaluator");
    EXPECT_EQ(record.ledger.charged, 1500);
  }
}

}  // namespace
}  // namespace ricochet
