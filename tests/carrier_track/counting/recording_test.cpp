#include "problems/carrier_track/counting/recording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "problems/carrier_track/counting/count.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

Scene bouncing_scene(CountRule rule) {
  Scene scene = exploratory_scene();
  scene.restitution_lower = scene.restitution_upper = 0.9;
  scene.rule = rule;
  scene.peak_high = 0.9e-3;
  scene.peak_low = 0.1e-3;
  return scene;
}

TEST(Recording, CountsAsTheObjectiveDoes) {
  for (const CountRule rule : {CountRule::impacts, CountRule::peaks}) {
    Scene scene = bouncing_scene(rule);
    for (const double omega : {1.0, 4.0, 11.0}) {
      scene.omega = omega;
      const Recording recording = record(scene, 0.25, 0);
      EXPECT_EQ(recording.count, objective(scene, 0.0));
      EXPECT_DOUBLE_EQ(recording.surrogate, objective(scene, 0.25));
      EXPECT_TRUE(recording.path.empty());
    }
  }
}

TEST(Recording, KeepsAPathWithinTheWallsThatTouchesThemAtTheImpacts) {
  Scene scene = exploratory_scene();
  scene.omega = 10.0;
  const Recording recording = record(scene, 0.25, 1000);
  ASSERT_GE(recording.path.size(), 1000U);
  double time = 0;
  for (const Sample& s : recording.path) {
    EXPECT_GE(s.time, time - 1e-15);
    EXPECT_GE(s.position, -1e-12);
    EXPECT_LE(s.position, scene.wall_upper + 1e-12);
    time = s.time;
  }
  EXPECT_DOUBLE_EQ(recording.path.front().position, scene.start_position);
  EXPECT_DOUBLE_EQ(time, recording.end.time);
  for (const Impact& impact : recording.impacts) {
    EXPECT_GE(impact.speed, 0.0);
  }
}

TEST(Recording, IsCertainAwayFromEveryLimitAndUncertainAtOne) {
  Scene scene = exploratory_scene();
  const Recording plain = record(scene, 0.25, 0);
  EXPECT_TRUE(plain.certainty.certain);
  EXPECT_GT(*plain.certainty.margin, 1e-3);
  // An impact exactly at the limit counts or not with the last digit.
  scene.counting_limit = plain.impacts.front().speed;
  const Recording close = record(scene, 0.25, 0);
  EXPECT_FALSE(close.certainty.certain);
  EXPECT_LT(*close.certainty.margin, 1e-9);
}

TEST(Recording, HasNoMarginWithoutFeatures) {
  Scene scene = exploratory_scene();
  scene.window = Seconds{1e-4};  // ends before the first wall
  const Recording recording = record(scene, 0.25, 0);
  EXPECT_FALSE(recording.certainty.margin);
  EXPECT_EQ(recording.count, 0);
  EXPECT_TRUE(recording.certainty.certain);
}

TEST(Recording, MarksAsManyFeaturesAsCount) {
  for (const CountRule rule : {CountRule::impacts, CountRule::peaks}) {
    Scene scene = bouncing_scene(rule);
    scene.omega = 11;
    const Recording recording = record(scene, 0.25, 0);
    ASSERT_GT(recording.count, 0);
    const auto counted = counted_features(scene, recording);
    EXPECT_EQ(static_cast<int>(counted.size()), recording.count);
    EXPECT_EQ(features_of(scene, recording).size(),
              rule == CountRule::impacts ? recording.impacts.size() : recording.peaks.size());
    for (const Feature& feature : counted) {
      const bool at_a_wall =
          feature.position == scene.wall_lower || feature.position == scene.wall_upper;
      const bool a_maximum_that_counts = feature.position > 0.9e-3 || feature.position < 0.1e-3;
      EXPECT_TRUE(rule == CountRule::impacts ? at_a_wall : a_maximum_that_counts);
    }
  }
}

TEST(Recording, ShowsWhereMostMaximaHappenWhereTheseCount) {
  Scene scene;
  scene.window = Seconds{10};
  scene.rule = CountRule::peaks;
  scene.peak_high = 0.9;
  scene.peak_low = 0.1;
  Recording recording;
  for (const double time : {2.0, 7.0, 7.1, 7.2, 7.3}) {
    recording.peaks.push_back({time, time > 3 ? 0.95 : 0.5});
  }
  for (const double time : {1.0, 1.1, 1.2, 1.3})
    recording.impacts.push_back({time, Wall::upper, 1});
  const auto stretch = busiest_stretch(scene, recording);
  ASSERT_TRUE(stretch);
  EXPECT_GT(stretch->from, 6);
  EXPECT_LT(stretch->to, 8);
}

TEST(Recording, ShowsWhereMostHappens) {
  Scene scene;
  scene.window = Seconds{10};
  scene.counting_limit = 0.1;
  Recording recording;
  for (const double time : {1.0, 4.0, 4.1, 4.2, 9.0}) {
    recording.impacts.push_back({time, Wall::upper, 1});
  }
  EXPECT_FALSE(busiest_stretch(scene, recording));  // four of five from 1 s on: too much
  for (const double time : {4.3, 4.4, 4.5}) recording.impacts.push_back({time, Wall::upper, 1});
  std::sort(recording.impacts.begin(), recording.impacts.end(),
            [](const Impact& a, const Impact& b) { return a.time < b.time; });
  const auto stretch = busiest_stretch(scene, recording);
  ASSERT_TRUE(stretch);
  EXPECT_NEAR(stretch->from, 4 - 0.125, 1e-12);
  EXPECT_NEAR(stretch->to, 4.5 + 0.125, 1e-12);
  for (Impact& impact : recording.impacts) impact.speed = 0.01;
  EXPECT_FALSE(busiest_stretch(scene, recording));  // none counts
}

TEST(Recording, HasNoSampleTwiceInARow) {
  const Recording recording = record(bouncing_scene(CountRule::impacts), 0.25, 500);
  ASSERT_GT(recording.path.size(), 400U);
  for (std::size_t k = 1; k < recording.path.size(); ++k) {
    const Sample& before = recording.path[k - 1];
    const Sample& after = recording.path[k];
    EXPECT_TRUE(before.time != after.time || before.position != after.position ||
                before.velocity != after.velocity)
        << k;
  }
}

TEST(Recording, RefusesASmoothingOrAPathThatIsNone) {
  const Scene scene = bouncing_scene(CountRule::impacts);
  EXPECT_NO_THROW(record(scene, 0, 0));
  for (const double smoothing :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(record(scene, smoothing, 0), InputError) << smoothing;
  }
  EXPECT_THROW(record(scene, 0.25, most_samples + 1), InputError);
  EXPECT_THROW(simulate(scene, 0.25, most_samples + 1), InputError);
}

TEST(Simulate, IsTheRecordingOfAValidScene) {
  Scene scene = exploratory_scene();
  scene.omega = 10.0;
  const Recording expected = record(scene, default_smoothing, 0);
  const Recording recording = simulate(scene);
  EXPECT_EQ(recording.count, expected.count);
  EXPECT_EQ(recording.surrogate, expected.surrogate);
  EXPECT_EQ(recording.end.position, expected.end.position);
  EXPECT_EQ(recording.impacts.size(), expected.impacts.size());
}

TEST(Simulate, RefusesWhatIsInvalid) {
  Scene scene = exploratory_scene();
  EXPECT_THROW(simulate(scene, 0), InputError);
  EXPECT_THROW(simulate(scene, std::numeric_limits<double>::infinity()), InputError);
  scene.mass = -1;
  EXPECT_THROW(simulate(scene), InputError);
}

}  // namespace
}  // namespace ricochet::carrier_track
