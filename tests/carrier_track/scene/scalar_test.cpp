#include <ceres/jet.h>
#include <gtest/gtest.h>

#include "ricochet/scene.h"

namespace ricochet::carrier_track {
namespace {

using PairDual = ceres::Jet<double, 2>;
using PairDualOfDuals = ceres::Jet<PairDual, 2>;

TEST(Scalar, VanishesOnlyWithAllItsDerivatives) {
  EXPECT_TRUE(vanishes(0.0));
  EXPECT_FALSE(vanishes(1e-300));
  EXPECT_TRUE(vanishes(PairDual(0.0)));
  EXPECT_FALSE(vanishes(PairDual(0.0, 1)));
  EXPECT_FALSE(vanishes(PairDual(1.0)));
  PairDualOfDuals x = constant<PairDualOfDuals>(0.0);
  EXPECT_TRUE(vanishes(x));
  x.v[1].v[0] = 1;
  EXPECT_FALSE(vanishes(x));
}

TEST(Scalar, IsConstantWithoutDerivativesOfTheOutermostOrder) {
  EXPECT_TRUE(is_constant(1.0));
  EXPECT_TRUE(is_constant(PairDual(1.0)));
  EXPECT_FALSE(is_constant(PairDual(1.0, 1)));
  EXPECT_TRUE(is_constant(PairDualOfDuals(PairDual(1.0, 1))));
}

TEST(Scalar, IsScaledWithAllItsDerivatives) {
  PairDualOfDuals x(PairDual(1.0, 0));
  x.v[1] = PairDual(3.0, 1);
  const PairDualOfDuals y = scaled(x, -2);
  EXPECT_EQ(y.a.a, -2);
  EXPECT_EQ(y.a.v[0], -2);
  EXPECT_EQ(y.v[1].a, -6);
  EXPECT_EQ(y.v[1].v[1], -2);
  EXPECT_EQ(y.v[0].a, 0);
}

TEST(Scalar, TakesAsManyNewtonStepsAsItHasOrders) {
  EXPECT_EQ(newton_steps<double>, 0);
  EXPECT_EQ(newton_steps<long double>, 2);
  EXPECT_EQ(newton_steps<PairDual>, 1);
  EXPECT_EQ(newton_steps<PairDualOfDuals>, 2);
}

}  // namespace
}  // namespace ricochet::carrier_track
