#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/suite/machine.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

TEST(Collisions, StepIsTheHeavisideStepAtSmoothingZero) {
  EXPECT_EQ(step(1e-300, 0.0), 1.0);
  EXPECT_EQ(step(0.0, 0.0), 0.0);
  EXPECT_EQ(step(-1e-300, 0.0), 0.0);
}

TEST(Collisions, StepIsALogisticAtAnyOtherSmoothing) {
  for (const double smoothing : {1e-3, 0.25, 2.0}) {
    EXPECT_EQ(step(0.0, smoothing), 0.5);
    double last = 0;
    for (double z = -3; z <= 3; z += 0.01) {
      const double weight = step(z, smoothing);
      EXPECT_NEAR(weight, 0.5 * (1 + std::tanh(z / smoothing / 2)), 1e-15);
      EXPECT_NEAR(weight + step(-z, smoothing), 1.0, 1e-15);
      EXPECT_GE(weight, last);
      last = weight;
    }
    EXPECT_EQ(step(1e6, smoothing), 1.0);
    EXPECT_EQ(step(-1e6, smoothing), 0.0);
    EXPECT_EQ(step(-std::numeric_limits<double>::infinity(), smoothing), 0.0);
  }
}

TEST(Collisions, FadesToTheEndOfTheWindowWithoutACorner) {
  EXPECT_EQ(fading(0.0, 0.0), 1.0);
  for (const double smoothing : {0.01, 0.25, 1.0}) {
    EXPECT_EQ(fading(0.0, smoothing), 0.0);
    EXPECT_NEAR(fading(0.1 * smoothing, smoothing), 1 - 1 / std::numbers::e, 1e-15);
    EXPECT_EQ(fading(0.65 * smoothing, smoothing), 1.0);
    EXPECT_NEAR(fading(std::nextafter(0.65 * smoothing, 0.0), smoothing), 1.0, 1e-15);
    EXPECT_LT(fading(1e-6 * smoothing, smoothing), 1e-9) << "its slope at the end is 0";
    EXPECT_EQ(weight(0.7, 0.1 * smoothing, smoothing),
              step(0.7, smoothing) * fading(0.1 * smoothing, smoothing));
  }
}

TEST(Collisions, CountsWhatTheExploratoryStudyCounted) {
  // The interpretation that the calibration starts from.
  constexpr std::array<double, 7> speeds = {1, 2, 3, 5, 9, 13, 17};
  struct Row {
    std::string id;
    std::array<int, 7> counts;
  };
  for (const Row& row : {Row{"C1", {1, 1, 3, 4, 4, 7, 7}}, Row{"C2", {13, 14, 24, 40, 55, 66, 73}},
                         Row{"C3", {1, 1, 3, 4, 4, 7, 7}}, Row{"C4", {5, 6, 11, 23, 47, 62, 69}}}) {
    Scene scene = scene_of(find_case(row.id), exploratory_scene());
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      scene.omega = speeds[i];
      EXPECT_EQ(objective(scene, 0.0), row.counts[i]) << row.id << " at " << speeds[i];
    }
  }
}

/// Thrown up from the floor at 8 m/s against 2 m/s^2, e = 1/2: apexes at 16, 4, 1, 1/4, ... m.
Scene thrown_ball() {
  Scene scene;
  scene.wall_upper = std::numeric_limits<double>::infinity();
  scene.start_position = 0.0;
  scene.start_velocity = 8.0;
  scene.pull = 2.0;
  scene.restitution_lower = 0.5;
  scene.window = Seconds{30.0};
  scene.counting_limit = 3.0;
  scene.rule = CountRule::peaks;
  scene.peak_high = 3.0;
  scene.peak_low = 1e-9;
  return scene;
}

TEST(Collisions, CountsTheImpactsFasterThanTheLimit) {
  Scene scene = thrown_ball();  // impacts at 8, 4, 2, 1, ... m/s
  scene.rule = CountRule::impacts;
  EXPECT_EQ(objective(scene, 0.0), 2.0);
  scene.counting_limit = 0.9;
  EXPECT_EQ(objective(scene, 0.0), 4.0);
  // Weights 1 / (1 + (limit / v)^4) at smoothing parameter 1/4.
  double sum = 0;
  for (double v = 8; v > 1e-6; v /= 2) sum += 1 / (1 + std::pow(0.9 / v, 4));
  EXPECT_NEAR(objective(scene, 0.25), sum, 1e-12);
}

TEST(Collisions, CountsHighAndLowPeaks) {
  Scene scene = thrown_ball();
  scene.window = Seconds{8.0 + 4.0 + 2.0 + 1.0};  // ends on the floor after the fourth apex
  EXPECT_EQ(objective(scene, 0.0), 2.0);          // 16 and 4
  scene.peak_high = 0.5;
  EXPECT_EQ(objective(scene, 0.0), 3.0);
  scene.peak_high = 5.0;
  scene.peak_low = 0.5;
  EXPECT_EQ(objective(scene, 0.0), 1.0 + 1.0);  // 16 is high, 1/4 is low
  const auto steps = [](double a) {
    return 1 / (1 + std::exp(-(a - 5) / 5 / 0.5)) + 1 / (1 + std::exp(-(0.5 - a) / 0.5 / 0.5));
  };
  // The apexes are 11, 5, 2 and 1/2 s from the end of the window of 15 s.
  const auto faded = [](double left) { return 1 - std::exp(-std::pow(left / 15 / 0.05, 2)); };
  const double sum =
      steps(16) * faded(11) + steps(4) * faded(5) + steps(1) * faded(2) + steps(0.25) * faded(0.5);
  EXPECT_NEAR(objective(scene, 0.5), sum, 1e-12);
}

TEST(Collisions, ListsEachPeakOnceWithItsTimeAndPlace) {
  Scene scene = thrown_ball();
  scene.window = Seconds{14.75};
  const auto tops = watch(scene).tops;
  ASSERT_EQ(tops.size(), 4U);  // the fifth hop has not turned yet
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(tops[k].position, 16 * std::pow(0.25, k), 1e-13);
  }
  EXPECT_NEAR(tops[0].time, 4.0, 1e-14);
  EXPECT_NEAR(tops[1].time, 10.0, 1e-14);
  EXPECT_NEAR(tops[2].time, 13.0, 1e-14);
}

TEST(Collisions, CallsAnImpactOnTheUpperWallAPeakAndTheEndsOfTheWindowNone) {
  Scene scene;
  scene.start_velocity = 1.0;
  scene.window = Seconds{1.0};
  auto tops = watch(scene).tops;
  ASSERT_EQ(tops.size(), 1U);
  EXPECT_DOUBLE_EQ(tops[0].time, 0.5);
  EXPECT_EQ(tops[0].position, 1.0);
  scene.window = Seconds{0.4};  // still on its way up
  EXPECT_TRUE(watch(scene).tops.empty());
  scene.start_velocity = -1.0;  // down from the start
  EXPECT_TRUE(watch(scene).tops.empty());
}

TEST(Collisions, CallsAPlateauAPeakOnceItFallsAtTheTimeItWasReached) {
  // Slides up to a stop and is held until a growing force takes it on, up or down.
  for (const double sign : {1.0, -1.0}) {
    Scene scene;
    scene.start_velocity = 0.1;
    scene.friction = 0.5;
    scene.normal_force = 2.0;
    scene.centrifugal_mass_radius = 1.5;
    scene.phase = -sign * std::acos(0.0);  // x'' = sign 1.5 sin t
    scene.window = Seconds{1.2};
    const auto watched = watch(scene);
    ASSERT_EQ(watched.stretches.size(), 3U);
    if (sign > 0) {
      EXPECT_TRUE(watched.tops.empty());
      continue;
    }
    ASSERT_EQ(watched.tops.size(), 1U);
    EXPECT_EQ(watched.tops[0].time, watched.stretches[1].time);
    EXPECT_EQ(watched.tops[0].position, watched.stretches[1].flight.position);
  }
}

TEST(Collisions, SurrogateTendsToTheCountAsTheSmoothingShrinks) {
  RandomScenes draws(21);
  for (const Case& a_case : all_cases()) {
    Scene scene = scene_of(a_case, exploratory_scene());
    for (int i = 0; i < 10; ++i) {
      scene.omega = draws.within(1.0, 18.0);
      double nearest = std::numeric_limits<double>::infinity();
      double last = 1;  // share of the window after the last impact that counts
      auto margin = [&](double z, double left) {
        nearest = std::min(nearest, std::abs(z));
        if (z > 0) last = std::min(last, left);
      };
      Features<double, decltype(margin)> features(scene, margin);
      const auto hits = watch(scene).hits;
      for (const auto& hit : hits) features.impact(hit.time, hit.wall, hit.speed);
      // Every weight is off by less than exp(-nearest / smoothing parameter).
      for (const double share : {5.0, 20.0, 40.0}) {
        const double smoothing = std::min(nearest / share, last / 0.65);
        const double bound = static_cast<double>(hits.size()) * std::exp(-nearest / smoothing);
        EXPECT_NEAR(objective(scene, smoothing), objective(scene, 0.0), bound + 1e-12);
      }
    }
  }
}

TEST(Collisions, SurrogateIsContinuousWhereAnImpactIsBorn) {
  // A ball whose apex comes up to the upper wall as its start gets faster than 4 m/s.
  Scene scene = thrown_ball();
  scene.rule = CountRule::impacts;
  scene.pull = 8.0;
  scene.wall_upper = 1.0;
  scene.restitution_upper = 0.3;
  const auto value_at = [&](double velocity) {
    scene.start_velocity = velocity;
    return objective(scene, 0.25);
  };
  const auto impacts_at = [&](double velocity) {
    scene.start_velocity = velocity;
    return watch(scene).hits.size();
  };
  for (const double distance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    EXPECT_GT(impacts_at(4.0 + distance), impacts_at(4.0 - distance) - 3);
    // The born impact strikes at sqrt(8 distance), which is what the path feels.
    const double jump = std::abs(value_at(4.0 + distance) - value_at(4.0 - distance));
    EXPECT_LT(jump, 3 * std::sqrt(8 * distance));
    EXPECT_GT(jump, 0.0);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
