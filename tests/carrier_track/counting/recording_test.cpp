#include "problems/carrier_track/counting/recording.h"

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

Scene bouncing_scene(CountRule rule, double omega) {
  return with(exploratory_scene(), set::restitution(0.9), set::rule(rule), set::peak_high(0.9e-3),
              set::peak_low(0.1e-3), set::omega(omega));
}

TEST(Recording, CountsAsTheObjectiveDoesAndMarksAsManyFeatures) {
  for (const CountRule rule : {CountRule::impacts, CountRule::peaks}) {
    for (const double omega : {1.0, 4.0, 11.0}) {
      const Scene scene = bouncing_scene(rule, omega);
      const Recording recording = record(scene, 0.25, 0);
      EXPECT_EQ(recording.count, objective(scene, 0.0));
      EXPECT_DOUBLE_EQ(recording.surrogate, objective(scene, 0.25));
      EXPECT_TRUE(recording.path.empty());
      EXPECT_EQ(features_of(scene, recording).size(),
                rule == CountRule::impacts ? recording.impacts.size() : recording.peaks.size());
      const auto counted = counted_features(scene, recording);
      EXPECT_EQ(static_cast<int>(counted.size()), recording.count);
      for (const Feature& feature : counted) {
        const double at = feature.position;
        EXPECT_TRUE(rule == CountRule::impacts ? at == scene.wall_lower || at == scene.wall_upper
                                               : at > 0.9e-3 || at < 0.1e-3);
      }
      if (omega == 11) {
        EXPECT_GT(recording.count, 0);
      }
    }
  }
}

TEST(Recording, KeepsAPathWithinTheWallsThatNeverStands) {
  const auto all_of = [](const Sample& s) { return std::tuple(s.time, s.position, s.velocity); };
  for (const Scene& scene :
       {with(exploratory_scene(), set::omega(10)), bouncing_scene(CountRule::impacts, 3)}) {
    const Recording recording = record(scene, 0.25, 1000);
    ASSERT_GE(recording.path.size(), 1000U);
    for (std::size_t k = 0; k < recording.path.size(); ++k) {
      const Sample& s = recording.path[k];
      EXPECT_GE(s.position, -1e-12);
      EXPECT_LE(s.position, scene.wall_upper + 1e-12);
      if (k == 0) continue;
      EXPECT_GE(s.time, recording.path[k - 1].time - 1e-15);
      EXPECT_NE(all_of(s), all_of(recording.path[k - 1])) << k;
    }
    EXPECT_DOUBLE_EQ(recording.path.front().position, scene.start_position);
    EXPECT_DOUBLE_EQ(recording.path.back().time, recording.end.time);
    for (const Impact& impact : recording.impacts) EXPECT_GE(impact.speed, 0.0);
  }
}

TEST(Recording, IsCertainAwayFromEveryLimitAndUncertainAtOne) {
  const auto certainty = [](const Scene& scene) { return record(scene, 0.25, 0).certainty; };
  const Scene scene = exploratory_scene();
  EXPECT_TRUE(certainty(scene).certain);
  EXPECT_GT(*certainty(scene).margin, 1e-3);
  // An impact exactly at the limit counts or not with the last digit.
  const double speed = record(scene, 0.25, 0).impacts.front().speed;
  const Certainty close = certainty(with(scene, set::counting_limit(speed)));
  EXPECT_FALSE(close.certain);
  EXPECT_LT(*close.margin, 1e-9);
  // A window that ends before the first wall has no features.
  const Certainty brief = certainty(with(scene, set::seconds(1e-4)));
  EXPECT_FALSE(brief.margin);
  EXPECT_TRUE(brief.certain);
}

TEST(Recording, ShowsWhereMostMaximaHappenWhereTheseCount) {
  const Scene scene = with(Scene{}, set::seconds(10), set::rule(CountRule::peaks),
                           set::peak_high(0.9), set::peak_low(0.1));
  Recording recording;
  recording.peaks = {{2.0, 0.5}, {7.0, 0.95}, {7.1, 0.95}, {7.2, 0.95}, {7.3, 0.95}};
  for (const double time : {1.0, 1.1, 1.2, 1.3}) {
    recording.impacts.push_back({time, Wall::upper, 1});
  }
  const auto stretch = busiest_stretch(scene, recording);
  ASSERT_TRUE(stretch);
  EXPECT_GT(stretch->from, 6);
  EXPECT_LT(stretch->to, 8);
}

TEST(Recording, ShowsWhereMostHappens) {
  const Scene scene = with(Scene{}, set::seconds(10), set::counting_limit(0.1));
  const auto of_impacts = [](const std::vector<double>& times, double speed) {
    Recording recording;
    for (const double time : times) recording.impacts.push_back({time, Wall::upper, speed});
    return recording;
  };
  // Four of five from 1 s on: too much.
  EXPECT_FALSE(busiest_stretch(scene, of_impacts({1, 4, 4.1, 4.2, 9}, 1)));
  const std::vector<double> busy{1, 4, 4.1, 4.2, 4.3, 4.4, 4.5, 9};
  const auto stretch = busiest_stretch(scene, of_impacts(busy, 1));
  ASSERT_TRUE(stretch);
  EXPECT_NEAR(stretch->from, 4 - 0.125, 1e-12);
  EXPECT_NEAR(stretch->to, 4.5 + 0.125, 1e-12);
  EXPECT_FALSE(busiest_stretch(scene, of_impacts(busy, 0.01))) << "none counts";
}

TEST(Recording, RefusesASmoothingOrAPathThatIsNone) {
  const Scene scene = exploratory_scene();
  EXPECT_NO_THROW(record(scene, 0, 0));
  for (const double smoothing : {-1.0, quiet_nan, infinity}) {
    EXPECT_THROW(record(scene, smoothing, 0), InputError) << smoothing;
  }
  EXPECT_THROW(record(scene, 0.25, most_samples + 1), InputError);
}

TEST(Simulate, IsTheRecordingOfAValidScene) {
  const Scene scene = with(exploratory_scene(), set::omega(10));
  const auto told = [](const Recording& r) {
    return std::tuple(r.count, r.surrogate, r.end.position, r.impacts.size());
  };
  EXPECT_EQ(told(simulate(scene)), told(record(scene, default_smoothing, 0)));
  EXPECT_THROW(simulate(scene, 0), InputError);
  EXPECT_THROW(simulate(scene, infinity), InputError);
  EXPECT_THROW(simulate(scene, 0.25, most_samples + 1), InputError);
  EXPECT_THROW(simulate(with(scene, set::mass(-1))), InputError);
}

/// A bouncing ball whose second impact, at half the speed of the first, is about the limit.
Scene ball_at_limit(double excess, Fidelity fidelity) {
  return with(Scene{}, set::wall_upper(10), set::restitution_lower(0.5), set::pull(9.8),
              set::start_position(1), set::seconds(1.2),
              set::counting_limit(0.5 * std::sqrt(2 * 9.8) * (1 - excess)),
              set::contact_law(ContactLaw::exact_restitution), set::stiffness(1e8),
              set::fidelity(fidelity));
}

TEST(Level, IsImpactWhereItsCountIsCertainAndThatOfTheSceneUnlessLeftOpen) {
  const Scene scene = ball_at_limit(1e-3, Fidelity::automatic);
  EXPECT_EQ(needed_fidelity(scene), Fidelity::impact);
  EXPECT_EQ(record(scene, default_smoothing, 0).fidelity, Fidelity::impact);
  EXPECT_EQ(record(scene, default_smoothing, 0).count, 2);
  for (const Fidelity level : {Fidelity::impact, Fidelity::compliant}) {
    EXPECT_EQ(resolve_fidelity(ball_at_limit(1e-13, level)).fidelity, level);
  }
}

TEST(Level, IsCompliantWhereHardWallsLeaveTheCountOpenAndItSettlesIt) {
  const auto recorded = [](Fidelity fidelity) {
    return record(ball_at_limit(1e-13, fidelity), default_smoothing, 0);
  };
  ASSERT_FALSE(recorded(Fidelity::impact).certainty.certain);
  const Recording recording = recorded(Fidelity::automatic);
  EXPECT_EQ(recording.fidelity, Fidelity::compliant);
  EXPECT_TRUE(recording.certainty.certain);
  // Pressed by its weight, the ball loses in a wall that gives way a little more or less.
  EXPECT_EQ(recording.count, recorded(Fidelity::compliant).count);
  EXPECT_EQ(objective(ball_at_limit(1e-13, Fidelity::automatic), 0.0), recording.count);
}

TEST(Level, IsImpactWhereNoLevelIsCertain) {
  // Chaos: a shaken gap with a pull, long enough for any digit to matter.
  const Scene scene =
      with(Scene{}, set::wall_upper(0.6e-3), set::restitution(0.8), set::disturbance(0.79),
           set::pull(0.39), set::disturbance_frequency(62.8), set::start(0.3e-3, 0.03),
           set::seconds(30), set::contact_law(ContactLaw::exact_restitution), set::stiffness(1e12));
  EXPECT_EQ(needed_fidelity(scene), Fidelity::impact);
  const Scene open = with(scene, set::fidelity(Fidelity::automatic));
  EXPECT_FALSE(record(open, default_smoothing, 0).certainty.certain);
}

TEST(Level, IsPlanarWhereTheSecondDirectionActs) {
  const auto pulled = [](double pull) {
    return with(ball_at_limit(1e-3, Fidelity::automatic), set::friction(0.2), set::normal_force(1),
                set::across(Across<double>{.pull = pull}));
  };
  EXPECT_FALSE(couples(pulled(0.1))) << "friction holds it, with up to 0.2 N";
  EXPECT_EQ(needed_fidelity(pulled(0.1)), Fidelity::impact);
  EXPECT_TRUE(couples(pulled(0.3)));
  EXPECT_EQ(needed_fidelity(pulled(0.3)), Fidelity::planar);
  EXPECT_EQ(record(pulled(0.3), default_smoothing, 0).fidelity, Fidelity::planar);
  EXPECT_FALSE(couples(with(pulled(0.3), set::friction(0)))) << "nothing is handed on";
}

TEST(Level, NeverLeavesOutASecondDirectionThatMatters) {
  RandomScenes scenes(61);
  const auto speeds_of = [](const Scene& scene) {
    std::vector<double> speeds;
    for (const auto& hit : watch(scene).hits) speeds.push_back(hit.speed);
    return speeds;
  };
  int alone = 0;
  for (int i = 0; i < 1000; ++i) {
    Scene scene = scenes.next_planar();
    scene.across->pull *= 0.5;
    if (scenes.chance(0.5)) scene.across->start_velocity = 0;
    if (couples(scene)) continue;
    ++alone;
    ASSERT_EQ(speeds_of(scene), speeds_of(with(scene, set::fidelity(Fidelity::impact)))) << i;
  }
  EXPECT_GT(alone, 100);
}

TEST(Level, IsChosenAnewForEverySceneThatLeavesItOpen) {
  const auto times_of = [](const Watched<double>& watched) {
    std::vector<double> times;
    for (const auto& hit : watched.hits) times.push_back(hit.time);
    return times;
  };
  for (const double excess : {1e-3, 1e-13}) {
    Watched<double> open, fixed;
    const Scene scene = ball_at_limit(excess, Fidelity::automatic);
    simulate_at_needed_fidelity(scene, open);
    simulate(with(scene, set::fidelity(needed_fidelity(scene))), fixed);
    EXPECT_EQ(times_of(open), times_of(fixed));
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
