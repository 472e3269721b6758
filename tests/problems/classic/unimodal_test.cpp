#include <gtest/gtest.h>

#include <cmath>

#include "problems/classic/functions.h"

namespace ricochet::classic {
namespace {

double value_at(const Problem& problem, const Vector& x) {
  return problem.evaluate(x).objective;
}

TEST(Unimodal, HasTheValuesWorkedByHand) {
  EXPECT_EQ(value_at(sphere(3), Vector{{1, 2, -3}}), 14);
  EXPECT_NEAR(value_at(ellipsoid(3), Vector{{1, 2, 3}}), 1 + 4e3 + 9e6, 1e-6);
  EXPECT_NEAR(value_at(rosenbrock(2), Vector{{-1.2, 1}}), 24.2,
              1e-13);  // published with the function
  EXPECT_EQ(value_at(rosenbrock(3), Vector{{0, 1, 2}}), 100 + 1 + 100 + 0);
  EXPECT_EQ(value_at(zakharov(2), Vector{{1, 1}}), 2 + 2.25 + 5.0625);
  EXPECT_EQ(value_at(dixon_price(3), Vector{{0, 1, 1}}), 1 + 2 * 4 + 3);
  EXPECT_EQ(value_at(schwefel_1_2(3), Vector{{1, 2, -3}}), 1 + 9 + 0);
  EXPECT_EQ(value_at(powell_singular(), Vector{{3, -1, 0, 1}}), 215);  // published
}

TEST(Unimodal, StepsWhereARoundedCoordinateDoes) {
  const Problem problem = step(2);
  EXPECT_EQ(value_at(problem, Vector{{0.49, -0.5}}), 0);
  EXPECT_EQ(value_at(problem, Vector{{0.5, -0.5}}), 1);
  EXPECT_EQ(value_at(problem, Vector{{1.5, -0.51}}), 4 + 1);
  EXPECT_FALSE(problem.differentiate);
}

TEST(Unimodal, DoesNotHaveTheOptimumAtTheCentre) {
  for (const Problem& problem : {sphere(2), ellipsoid(2), rosenbrock(2), zakharov(2),
                                 dixon_price(2), schwefel_1_2(2), powell_singular(), step(2)}) {
    const Vector centre = (problem.lower + problem.upper) / 2;
    EXPECT_GT(value_at(problem, centre), 0.1) << problem.name;
  }
}

TEST(Unimodal, RosenbrockHasASecondValleyFromFourVariablesOn) {
  // Close to the published local minimum near (-1, 1, 1, 1): 3.70 for n = 4, doi
  // 10.1162/evco.2006.14.1.119.
  const Vector x{{-0.775659, 0.613093, 0.382063, 0.145973}};
  EXPECT_LT(rosenbrock(4).differentiate(x).gradient.norm(), 1e-2);
  EXPECT_NEAR(value_at(rosenbrock(4), x), 3.7014, 1e-3);
}

}  // namespace
}  // namespace ricochet::classic
