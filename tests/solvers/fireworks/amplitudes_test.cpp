#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "solvers/fireworks/sparks.h"

namespace ricochet::fireworks {
namespace {

constexpr double epsilon = 2.2e-16;

TEST(ExplosionAmplitudes, GrowWithTheDistanceToTheBest) {
  const Vector spread = explosion_amplitudes(Vector{{0, 1, 2, 3, 4}}, 40, epsilon);
  EXPECT_LT((spread - Vector{{0, 4, 8, 12, 16}}).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(ExplosionAmplitudes, LeaveTheBestNextToNothing) {
  const Vector tied_but_one = explosion_amplitudes(Vector{{7, 7, 7, 7, 8}}, 40, epsilon);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(tied_but_one[i], 40 * epsilon, 1e-18);
  EXPECT_NEAR(tied_but_one[4], 40, 1e-12);
}

TEST(ExplosionAmplitudes, AreAllTheWholeWhereAllAreTied) {
  EXPECT_EQ(explosion_amplitudes(Vector::Constant(5, 7), 40, epsilon), Vector::Constant(5, 40));
}

TEST(AmplitudeFloor, FallsAlongAQuarterOfAnEllipse) {
  const AmplitudeFloor floor{0.02, 0.001};
  EXPECT_DOUBLE_EQ(floor.after(0, 1000), 0.02);
  EXPECT_DOUBLE_EQ(floor.after(1000, 1000), 0.001);
  for (const double t : {0.1, 0.3, 0.7, 0.95}) {
    // With 1 - t = cos(angle) the root is sin(angle).
    EXPECT_NEAR(floor.after(1000 * t, 1000), 0.02 - 0.019 * std::sin(std::acos(1 - t)), 1e-15);
  }
  EXPECT_DOUBLE_EQ(floor.after(0, 0), 0.02);
}

TEST(AmplitudeSteps, GrowOnSuccessAndDeclineElse) {
  const AmplitudeSteps steps;
  EXPECT_DOUBLE_EQ(steps.next(10, true), 12);
  EXPECT_DOUBLE_EQ(steps.next(10, false), 9);
}

TEST(AmplitudeSteps, AreRefusedWhereTheyAreNone) {
  EXPECT_THROW(check(AmplitudeSteps{0.9, 0.9}), std::invalid_argument);
  EXPECT_THROW(check(AmplitudeSteps{1.2, 1.1}), std::invalid_argument);
  EXPECT_THROW(check(AmplitudeSteps{1.2, 0}), std::invalid_argument);
  EXPECT_THROW(check(AmplitudeSteps{std::nan(""), 0.9}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet::fireworks
