#include "problems/carrier_track/suite/profile.h"

#include <gtest/gtest.h>

#include <numbers>

#include "problems/carrier_track/counting/threshold.h"
#include "src/core/instance.h"
#include "tests/carrier_track/gradients/differences.h"
#include "tests/support/scenes.h"
#include "tests/carrier_track/suite/machine_of_case.h"

namespace ricochet::carrier_track {
namespace {

/// [rad]: how far the driver plate turns within the profile, exactly.
double angle_of(const std::vector<SpeedKnot<double>>& profile) {
  double angle = 0;
  for (std::size_t k = 1; k < profile.size(); ++k) {
    angle +=
        (profile[k].time - profile[k - 1].time) * (profile[k].omega + profile[k - 1].omega) / 2;
  }
  return angle;
}

Vector some_shape(const Problem& problem) {
  Random random(7);
  return uniform_point(problem, random);
}

TEST(Profile, KeepsItsMeanSpeedWhateverTheShape) {
  const Machine c1 = machine("C1");
  const ProfileFrame frame = profile_frame(c1);
  EXPECT_EQ(frame.mean, 1.25 * 9.0);
  for (const std::size_t n : profile_sizes) {
    const Vector x = some_shape(profile_count_problem(c1, n));
    const Scene scene = with_profile(
        c1.scene, frame, std::span<const double>(x.data(), static_cast<std::size_t>(x.size())));
    ASSERT_EQ(scene.profile.size(), n);
    EXPECT_EQ(scene.profile.front().time, 0);
    EXPECT_NEAR(scene.profile.back().time, frame.seconds, 1e-12);
    EXPECT_NEAR(angle_of(scene.profile) / frame.seconds, frame.mean, 1e-12);
    // The same turns as the window has.
    EXPECT_NEAR(angle_of(scene.profile), 2 * std::numbers::pi * 1.314, 1e-11);
    EXPECT_NEAR(scene.profile[1].omega / scene.profile[0].omega, x[1] / x[0], 1e-12);
  }
}

TEST(Profile, OfNoShapeIsTheSteadySpeed) {
  for (const char* id : {"C1", "C2", "C9"}) {
    const Machine m = machine(id);
    const Problem problem = profile_count_problem(m, 8);
    EXPECT_EQ(problem.evaluate(problem.start).objective, count_at(m.scene, loud_speed(m))) << id;
    EXPECT_EQ(problem.evaluate(2 * problem.start).objective,
              problem.evaluate(problem.start).objective);
  }
}

TEST(Profile, TakesAWindowInSecondsAsItIs) {
  Machine m = machine("C1");
  m.scene.window = Seconds{2.5};
  EXPECT_EQ(profile_frame(m).seconds, 2.5);
}

TEST(Profile, HasDerivativesToEveryKnot) {
  for (const std::size_t n : {2U, 8U}) {
    const Problem problem = profile_count_problem(machine("C1"), n).formulated({0.25});
    EXPECT_EQ(problem.dimension(), static_cast<Eigen::Index>(n));
    expect_derivatives_of_values(problem, some_shape(problem), 1e-8, 1e-4);
    const Problem wear = profile_wear_problem(machine("C1"), n);
    expect_derivatives_of_values(wear, some_shape(wear), 1e-8, 1e-4);
  }
}

TEST(Profile, IsJudgedByTheTrueCount) {
  const Problem smooth = profile_count_problem(machine("C1"), 4).formulated({0.25});
  const Problem exact = profile_count_problem(machine("C1"), 4);
  const Vector x = some_shape(exact);
  EXPECT_EQ(smooth.true_values(x).objective, exact.evaluate(x).objective);
  EXPECT_EQ(smooth.smoothed(0.1).true_values(x).objective, exact.evaluate(x).objective);
  EXPECT_NE(smooth.smoothed(0.1).evaluate(x).objective, smooth.evaluate(x).objective);
}

}  // namespace
}  // namespace ricochet::carrier_track
