#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "problems/classic/functions.h"

namespace ricochet::classic {
namespace {

double at(const Problem& problem, double x, double y) {
  return problem.evaluate(Vector{{x, y}}).objective;
}

TEST(Plane, HasTheValuesWorkedByHand) {
  EXPECT_EQ(at(beale(), 1, 1), 14.203125);  // published
  EXPECT_EQ(at(beale(), 0, 0), 1.5 * 1.5 + 2.25 * 2.25 + 2.625 * 2.625);
  EXPECT_EQ(at(booth(), 0, 0), 49 + 25);
  EXPECT_EQ(at(himmelblau(), 0, 0), 121 + 49);
  EXPECT_EQ(at(six_hump_camel(), 0, 1), 0);
  EXPECT_NEAR(at(six_hump_camel(), 1, 0), 4 - 2.1 + 1.0 / 3, 1e-12);
  EXPECT_NEAR(at(branin(), 0, 6), 20 - 10 / (8 * std::numbers::pi), 1e-12);
}

TEST(Plane, HasThePublishedMinimaBesidesTheBest) {
  EXPECT_NEAR(at(goldstein_price(), -0.6, -0.4), 30, 1e-9);  // Goldstein and Price (1971)
  EXPECT_NEAR(at(goldstein_price(), 1.8, 0.2), 84, 1e-9);
  EXPECT_NEAR(at(goldstein_price(), 1.2, 0.8), 840, 1e-9);
  EXPECT_NEAR(at(himmelblau(), -2.805118, 3.131312), 0, 1e-9);
  EXPECT_NEAR(at(himmelblau(), -3.779310, -3.283186), 0, 1e-9);
  EXPECT_NEAR(at(himmelblau(), 3.584428, -1.848126), 0, 1e-9);
  EXPECT_NEAR(at(branin(), -std::numbers::pi, 12.275), *branin().best_known, 1e-12);
  EXPECT_NEAR(at(branin(), 3 * std::numbers::pi, 2.475), *branin().best_known, 1e-12);
  EXPECT_NEAR(*branin().best_known, 0.397887, 5e-7);
  EXPECT_NEAR(*six_hump_camel().best_known, -1.0316285, 5e-8);
  const Vector best = -*six_hump_camel().best_point;
  EXPECT_NEAR(at(six_hump_camel(), best[0], best[1]), *six_hump_camel().best_known, 1e-14);
}

TEST(Plane, IsStationaryAtItsBestPoint) {
  for (const Problem& problem :
       {beale(), booth(), himmelblau(), goldstein_price(), branin(), six_hump_camel()}) {
    EXPECT_LT(problem.differentiate(*problem.best_point).gradient.norm(), 1e-12) << problem.name;
  }
}

}  // namespace
}  // namespace ricochet::classic
