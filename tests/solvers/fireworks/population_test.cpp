#include "solvers/fireworks/population.h"

#include <gtest/gtest.h>

#include "tests/support/problems.h"

namespace ricochet::fireworks {
namespace {

TEST(Population, KeepsPointsAndTheirWorthsInTheirOrder) {
  const Problem problem = limited(7);
  Evaluator evaluator(problem, {4});
  Population population(evaluator, 4);
  for (const double x : {5.0, 9.0, 7.0, 1.0}) EXPECT_TRUE(population.add(Vector::Constant(1, x)));
  EXPECT_FALSE(population.add(Vector::Constant(1, 2.0))) << "the budget is spent";
  EXPECT_EQ(population.size(), 4);
  EXPECT_EQ(population.worth(1).violation, 2);
  EXPECT_EQ(population.worths().size(), 4U);

  const std::vector<Eigen::Index> chosen = {3, 0, 3};
  population.keep(chosen);
  EXPECT_EQ(population.points(), (Matrix{{1}, {5}, {1}}));
  EXPECT_EQ(population.worth(0).objective, -1);
  EXPECT_EQ(population.worth(1).objective, -5);
  EXPECT_EQ(population.worth(2).objective, -1);

  population.clear();
  EXPECT_EQ(population.size(), 0);
}

}  // namespace
}  // namespace ricochet::fireworks
