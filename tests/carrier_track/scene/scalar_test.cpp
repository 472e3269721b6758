#include "problems/carrier_track/scene/scalar.h"

#include <ceres/jet.h>
#include <gtest/gtest.h>

namespace ricochet::carrier_track {
namespace {

using Jet = ceres::Jet<double, 2>;
using Second = ceres::Jet<Jet, 2>;

TEST(Scalar, VanishesOnlyWithAllItsDerivatives) {
  EXPECT_TRUE(vanishes(0.0));
  EXPECT_FALSE(vanishes(1e-300));
  EXPECT_TRUE(vanishes(Jet(0.0)));
  EXPECT_FALSE(vanishes(Jet(0.0, 1)));
  EXPECT_FALSE(vanishes(Jet(1.0)));
  Second x = constant<Second>(0.0);
  EXPECT_TRUE(vanishes(x));
  x.v[1].v[0] = 1;
  EXPECT_FALSE(vanishes(x));
}

TEST(Scalar, IsConstantWithoutDerivativesOfTheOutermostOrder) {
  EXPECT_TRUE(is_constant(1.0));
  EXPECT_TRUE(is_constant(Jet(1.0)));
  EXPECT_FALSE(is_constant(Jet(1.0, 1)));
  EXPECT_TRUE(is_constant(Second(Jet(1.0, 1))));
}

TEST(Scalar, IsScaledWithAllItsDerivatives) {
  Second x(Jet(1.0, 0));
  x.v[1] = Jet(3.0, 1);
  const Second y = scaled(x, -2);
  EXPECT_EQ(y.a.a, -2);
  EXPECT_EQ(y.a.v[0], -2);
  EXPECT_EQ(y.v[1].a, -6);
  EXPECT_EQ(y.v[1].v[1], -2);
  EXPECT_EQ(y.v[0].a, 0);
}

TEST(Scalar, TakesAsManyNewtonStepsAsItHasOrders) {
  EXPECT_EQ(newton_steps<double>, 0);
  EXPECT_EQ(newton_steps<long double>, 2);
  EXPECT_EQ(newton_steps<Jet>, 1);
  EXPECT_EQ(newton_steps<Second>, 2);
}

}  // namespace
}  // namespace ricochet::carrier_track
