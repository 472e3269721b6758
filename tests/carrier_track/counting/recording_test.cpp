#include "problems/carrier_track/counting/recording.h"

#include "problems/carrier_track/counting/certainty.h"
#include "problems/carrier_track/counting/count.h"
#include "ricochet/error.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

using testing::DoubleEq, testing::DoubleNear;

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
      EXPECT_TRUE(omega < 11 || recording.count > 0);
      for (const Feature& feature : counted) {
        const double at = feature.position;
        EXPECT_TRUE(rule == CountRule::impacts ? at == scene.wall_lower || at == scene.wall_upper
                                               : at > 0.9e-3 || at < 0.1e-3);
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
      EXPECT_TRUE(s.position >= -1e-12 && s.position <= scene.wall_upper + 1e-12) << s.position;
      if (k == 0) continue;
      EXPECT_GE(s.time, recording.path[k - 1].time - 1e-15);
      EXPECT_NE(all_of(s), all_of(recording.path[k - 1])) << k;
    }
    EXPECT_DOUBLE_EQ(recording.path.front().position, scene.start_position);
    EXPECT_DOUBLE_EQ(recording.path.back().time, recording.end.time);
    for (const Impact& impact : recording.impacts) EXPECT_GE(impact.speed, 0.0);
  }
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
  EXPECT_THAT(
      busiest_stretch(scene, of_impacts(busy, 1)).value(),
      FieldsAre(testing::DoubleNear(4 - 0.125, 1e-12), testing::DoubleNear(4.5 + 0.125, 1e-12)));
  EXPECT_FALSE(busiest_stretch(scene, of_impacts(busy, 0.01))) << "none counts";
  // Where maxima count, they do.
  Recording recording = of_impacts({1.0, 1.1, 1.2, 1.3}, 1);
  recording.peaks = {{2.0, 0.5}, {7.0, 0.95}, {7.1, 0.95}, {7.2, 0.95}, {7.3, 0.95}};
  EXPECT_THAT(busiest_stretch(
                  with(scene, set::rule(CountRule::peaks), set::peak_high(0.9), set::peak_low(0.1)),
                  recording)
                  .value(),
              FieldsAre(testing::Gt(6), testing::Lt(8)));
}

TEST(Simulate, IsTheRecordingOfAValidScene) {
  const Scene scene = with(exploratory_scene(), set::omega(10));
  const auto told = [](const Recording& r) {
    return std::tuple(r.count, r.surrogate, r.end.position, r.impacts.size(), r.certainty.margin);
  };
  EXPECT_EQ(told(simulate(scene)), told(record(scene, default_smoothing, 0)));
  EXPECT_NO_THROW(record(scene, 0, 0));
  for (const double smoothing : {-1.0, quiet_nan, infinity}) {
    EXPECT_THROW(record(scene, smoothing, 0), InputError) << smoothing;
  }
  for (const double smoothing : {0.0, infinity}) {
    EXPECT_THROW(simulate(scene, smoothing), InputError) << smoothing;
  }
  EXPECT_THROW(record(scene, 0.25, most_samples + 1), InputError);
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
  int alone = 0;
  for (int i = 0; i < 1000 && !HasFatalFailure(); ++i) {
    Scene scene = scenes.next_planar();
    scene.across->pull *= 0.5;
    if (scenes.chance(0.5)) scene.across->start_velocity = 0;
    if (couples(scene)) continue;
    ++alone;
    SCOPED_TRACE(i);
    expect_hits(watch(scene).hits, watch(with(scene, set::fidelity(Fidelity::impact))).hits, 0, 0);
  }
  EXPECT_GT(alone, 100);
}

TEST(Level, IsChosenAnewForEverySceneThatLeavesItOpen) {
  for (const double excess : {1e-3, 1e-13}) {
    Watched<double> open, fixed;
    const Scene scene = ball_at_limit(excess, Fidelity::automatic);
    simulate_at_needed_fidelity(scene, open);
    simulate(with(scene, set::fidelity(needed_fidelity(scene))), fixed);
    expect_hits(open.hits, fixed.hits, 0, 0);
  }
}

/// A trace of a simulated scene, which it holds.
struct HeldScene {
  Scene scene;
};
struct Traced : HeldScene, FeatureTrace {
  explicit Traced(const Scene& given) : HeldScene{given}, FeatureTrace(HeldScene::scene) {
    simulate(scene, static_cast<FeatureTrace&>(*this));
  }
};

/// A body thrown up, which is highest at 0.5 s: 0.625 m.
Scene thrown_body() {
  return with(Scene{}, set::pull(1), set::start_velocity(0.5), set::seconds(1));
}

TEST(FeatureTrace, KeepsImpactsByTheirWall) {
  // Flies freely between walls 1 m apart: at 1 s it is on the upper, at 5 s on the lower.
  const Traced trace(with(Scene{}, set::start_velocity(0.5), set::restitution(0.5),
                          set::seconds(10), set::counting_limit(0.4)));
  const auto& upper = trace.features(FeatureTrace::upper_impact);
  const auto& lower = trace.features(FeatureTrace::lower_impact);
  ASSERT_THAT(upper, ElementsAre(FieldsAre(DoubleEq(1.0), DoubleEq(std::log(0.5 / 0.4)))));
  EXPECT_EQ(upper[0].margin(), upper[0].scaled);
  ASSERT_THAT(lower, ElementsAre(FieldsAre(DoubleEq(5.0), DoubleEq(0.25 / 0.4 - 1))));
  EXPECT_DOUBLE_EQ(lower[0].margin(), std::log(0.25 / 0.4)) << "too slow to count";
  EXPECT_EQ(trace.impacts(Wall::upper).size(), 1U);
  EXPECT_EQ(trace.impacts(Wall::lower).size(), 1U);
  EXPECT_TRUE(trace.features(FeatureTrace::high_peak).empty());
  EXPECT_FALSE(trace.graze()) << "a wall that is hit is not missed";
}

TEST(FeatureTrace, KeepsEveryMaximumWithBothItsMargins) {
  const Traced trace(
      with(thrown_body(), set::rule(CountRule::peaks), set::peak_high(0.5), set::peak_low(0.5)));
  const auto near = [](double expected) { return DoubleNear(expected, 1e-12); };
  EXPECT_THAT(trace.features(FeatureTrace::high_peak),
              ElementsAre(FieldsAre(near(0.5), near(0.25))));
  const auto& low = trace.features(FeatureTrace::low_peak);
  ASSERT_THAT(low, ElementsAre(FieldsAre(near(0.5), near(std::exp(-0.25) - 1))));
  EXPECT_NEAR(low[0].margin(), -0.25, 1e-12);
  EXPECT_TRUE(trace.features(FeatureTrace::upper_impact).empty());
}

TEST(FeatureTrace, TellsOfMaximaWithoutAnEnd) {
  const Scene peaks = with(thrown_body(), set::rule(CountRule::peaks), set::peak_high(0.5),
                           set::peak_low(1e-3), set::restitution_lower(0.5));
  // Down from 0.625 m, and up again at half the speed, each time. They end after three falls.
  const double fall = std::sqrt(2 * 0.625);
  const Scene planar = with(peaks, set::seconds(10), set::planar());
  for (const Fidelity level : {Fidelity::impact, Fidelity::planar}) {
    EXPECT_THAT(Traced(with(planar, set::fidelity(level))).endless().value(),
                FieldsAre(DoubleNear(0.5 + 3 * fall, 1e-8), Wall::lower));
  }
  const Scene compliant =
      with(peaks, set::fidelity(Fidelity::compliant), set::stiffness(1e4), set::seconds(10));
  EXPECT_TRUE(Traced(compliant).endless()) << "of swings in a wall";
  // The other way up the maxima lie on the wall itself, which is high.
  EXPECT_TRUE(Traced(with(thrown_body(), set::rule(CountRule::peaks), set::pull(-1),
                          set::start_velocity(0), set::restitution_upper(0.5), set::seconds(10)))
                  .endless());
  const std::map<std::string, Scene> ending = {
      {"none counts where the wall lies between the limits", with(planar, set::wall_lower(0.125))},
      {"the body stays on the wall", with(planar, set::restitution_lower(0))},
      {"there is an end before", with(planar, set::seconds(0.5 + fall))},
      {"before it comes down", with(compliant, set::seconds(1))}};
  for (const auto& [why, scene] : ending) EXPECT_FALSE(Traced(scene).endless()) << why;
}

TEST(FeatureTrace, KnowsAMaximumThatRoundingMakes) {
  // From rest by x'' = sin t: the speed 1 - cos t touches zero at every turn, and is never below.
  int told = 0;
  const Scene scene =
      with(Scene{}, set::wall_upper(100), set::rule(CountRule::peaks),
           set::centrifugal_mass_radius(1), set::start_position(0), set::seconds(30));
  for (int i = 0; i < 20; ++i) {
    // It is released when the force has turned.
    const Traced trace(with(scene, set::phase(-std::numbers::pi / 2 - 0.1 * i)));
    const bool one = !trace.features(FeatureTrace::high_peak).empty();
    EXPECT_EQ(trace.shallow_peak().has_value(), one);
    told += one ? 1 : 0;
  }
  EXPECT_GT(told, 0) << "none to doubt";
  EXPECT_FALSE(Traced(thrown_body()).shallow_peak());
}

/// Kinds, times and scaled margins of all features.
std::vector<std::tuple<std::size_t, double, double>> features_in(const FeatureTrace& trace) {
  std::vector<std::tuple<std::size_t, double, double>> all;
  for (std::size_t kind = 0; kind < FeatureTrace::kinds; ++kind) {
    for (const auto& each : trace.features(kind)) all.emplace_back(kind, each.time, each.scaled);
  }
  return all;
}

TEST(Neighbours, AreTheSameBesideTheSceneAndAlone) {
  RandomScenes random(21);
  std::size_t features = 0;
  for (int i = 0; i < 200; ++i) {
    const Scene scene = random.next();
    FeatureTrace trace(scene), alone(scene);
    Neighbours beside(scene), apart(scene);
    EXPECT_EQ(beside.simulate_with(scene, trace).position, simulate(scene, alone).position);
    ASSERT_EQ(features_in(trace), features_in(alone)) << i;
    for (std::size_t k = 0; k < 4; ++k) {
      ASSERT_EQ(features_in(beside.all()[k].trace), features_in(apart.all()[k].trace)) << i;
      features += apart.all()[k].trace.features(FeatureTrace::lower_impact).size();
    }
  }
  EXPECT_GT(features, 1000U);
}

TEST(Neighbours, LastALittleLongerThanTheScene) {
  const Scene scene = RandomScenes(22).next();
  Neighbours neighbours(scene);
  for (const Neighbour& n : neighbours.all()) {
    EXPECT_NEAR(n.end, duration_of(scene), 1e-8 * duration_of(scene));
    EXPECT_NEAR(duration_of(n.scene) / n.end, 1 + Neighbour::same_time, 1e-12);
  }
}

TEST(FeatureComparison, IsClearOnlyIfTheOppositeChangeRaisesNoDoubtEither) {
  int clear = 0;
  for (int i = 0; i < 3000; ++i) {
    const Scene scene = hostile_scene(31, i).scene;
    const Traced trace(scene);
    Neighbours neighbours(scene);
    bool one_side_is_clear = true;
    bool any_doubt = false;
    for (std::size_t k = 0; k < 4; ++k) {
      const Neighbour& near = neighbours.all()[k];
      const FeatureComparison comparison(trace, duration_of(scene), near.trace, near.end);
      if (k % 2 == 0 && !near.failure) one_side_is_clear &= comparison.is_clear();
      any_doubt |= near.failure || comparison.first().doubt != Doubt::none;
    }
    if (!one_side_is_clear) continue;
    ++clear;
    EXPECT_FALSE(any_doubt) << i;
  }
  EXPECT_GT(clear, 1000);
}

TEST(FeatureComparison, OfASceneWithItselfIsClearOnlyFarFromALimit) {
  // One impact, at 1 m/s.
  const Scene scene = with(Scene{}, set::restitution(0), set::start_velocity(1), set::seconds(1));
  for (const double share : {0.5, 1 - 1e-12, 1 - 1e-6}) {
    const Traced trace(with(scene, set::counting_limit(share)));
    const FeatureComparison comparison(trace, 1, trace, 1);
    EXPECT_EQ(comparison.first().doubt == Doubt::none, share < 1 - 1e-9) << share;
    EXPECT_EQ(comparison.is_clear(), share < 1 - 1e-7) << share;
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
