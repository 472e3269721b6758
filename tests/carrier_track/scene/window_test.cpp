#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "problems/carrier_track/scene/scene_values.h"

namespace ricochet::carrier_track {
namespace {

using std::numbers::pi;

TEST(Window, OfSecondsLastsSoLongAtAnySpeed) {
  Scene scene;
  scene.window = Seconds{7.25};
  scene.profile = {{0.0, 1.0}, {1.0, 9.0}};
  EXPECT_EQ(duration_of(scene), 7.25);
}

TEST(Window, OfRevolutionsTakesTheirAngleOverTheSpeed) {
  Scene scene;
  scene.omega = 4.0;
  scene.window = Revolutions{2.5};
  EXPECT_DOUBLE_EQ(duration_of(scene), 2.5 * 2 * pi / 4.0);
}

/// The angle [rad] that a profile turns by in a time [s], by the trapezoidal rule, which is exact
/// on the pieces of a straight line.
double angle_turned(const std::vector<SpeedKnot<double>>& profile, double until) {
  double angle = 0;
  SpeedKnot<double> last{0.0, profile.front().omega};
  for (SpeedKnot<double> next : profile) {
    if (next.time > until) {
      next.omega = std::lerp(last.omega, next.omega, (until - last.time) / (next.time - last.time));
      next.time = until;
    }
    angle += (next.time - last.time) * (last.omega + next.omega) / 2;
    last = next;
    if (last.time == until) return angle;
  }
  return angle + (until - last.time) * last.omega;
}

TEST(Window, OfRevolutionsEndsWhenTheProfileHasTurnedSoFar) {
  std::mt19937_64 random(3);
  const auto within = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int before = 0, among = 0, after = 0;  // the knots
  for (int i = 0; i < 300; ++i) {
    Scene scene;
    scene.profile = {{within(0.0, 0.3), within(1, 9)}};
    for (int k = 0; k < 3; ++k) {
      scene.profile.push_back({scene.profile.back().time + within(0.05, 0.4), within(1, 9)});
    }
    const double turns = within(0.001, 1.0);
    scene.window = Revolutions{turns};
    const double end = duration_of(scene);
    EXPECT_NEAR(angle_turned(scene.profile, end), 2 * pi * turns, 1e-13 * (1 + turns));
    ++(end < scene.profile.front().time ? before : end < scene.profile.back().time ? among : after);
  }
  EXPECT_GT(std::min({before, among, after}), 5);
}

TEST(Window, HasItsTurnsInSecondsAndInRevolutions) {
  Scene scene;
  scene.omega = 4 * pi;
  scene.window = Seconds{5};
  EXPECT_NEAR(turns_of(scene), 10, 1e-12);
  scene.window = Revolutions{1.5};
  EXPECT_NEAR(turns_of(scene), 1.5, 1e-12);
}

}  // namespace
}  // namespace ricochet::carrier_track
