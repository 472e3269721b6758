#include "problems/carrier_track/counting/certainty.h"

#include <ceres/jet.h>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/motion/simulate.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

using testing::HasSubstr;

Certainty certainty(const Scene& scene) {
  FeatureTrace trace(scene);
  Neighbours neighbours(scene);
  neighbours.simulate_with(scene, trace);
  return certainty_of(scene, trace, neighbours);
}

void expect_doubt(const Scene& scene, Doubt doubt, const std::string& reason) {
  const Certainty found = certainty(scene);
  EXPECT_FALSE(found.certain);
  EXPECT_EQ(found.doubt, doubt) << found.reason;
  EXPECT_THAT(found.reason, HasSubstr(reason));
}

/// A ball thrown up from the lower wall; without an upper one it is back after 2 v / gravity.
struct Ball {
  static constexpr double gravity = 9.8;  ///< [m/s^2]
  double speed = 3.0;                     ///< [m/s]
  double restitution = 0.8;

  double summit() const { return speed * speed / (2 * gravity); }  ///< [m]

  /// Speed [m/s] and time [s] of the k-th return, from 0.
  double impact_speed(int k) const { return speed * std::pow(restitution, k); }
  double impact_time(int k) const {
    return 2 * speed / gravity * (1 - std::pow(restitution, k + 1)) / (1 - restitution);
  }

  /// Its window ends after the impact of k = 4.
  Scene scene() const {
    return with(Scene{}, set::mass(1.3), set::pull(1.3 * gravity), set::wall_upper(infinity),
                set::restitution(restitution), set::start(0, speed), set::seconds(2.2),
                set::counting_limit(1));
  }
};

TEST(Certainty, OfAPlainSceneIsCertainWithAGrowthOfOrderOne) {
  const Ball ball;
  const Certainty plain = certainty(ball.scene());
  EXPECT_TRUE(plain.certain);
  EXPECT_EQ(plain.doubt, Doubt::none);
  EXPECT_EQ(plain.reason, "");
  // ln(e^k v0) changes k times as much as e, and as much as v0.
  EXPECT_GT(plain.growth, 0.5);
  EXPECT_LT(plain.growth, 7.0);
  // The last is the nearest to the limit.
  EXPECT_NEAR(*plain.margin, std::log(ball.impact_speed(4)), 1e-13);
  EXPECT_FALSE(plain.graze);  // there is no wall ahead
}

TEST(Certainty, DoubtsAnImpactAtTheSlowestSpeed) {
  const Ball ball;
  for (int k = 0; k < 5; ++k) {
    const auto limited = [&](double off) {
      return with(ball.scene(), set::counting_limit(ball.impact_speed(k) * (1 + off)));
    };
    for (const double off : {1e-12, -1e-12}) {
      expect_doubt(limited(off), Doubt::margin,
                   fmt::format("an impact at {:.6g} s is within ", ball.impact_time(k)));
      EXPECT_NEAR(*certainty(limited(off)).margin, 1e-12, 1e-14);
    }
    EXPECT_TRUE(certainty(limited(1e-7)).certain);
  }
}

TEST(Certainty, DoubtsAMaximumAtALimit) {
  const Ball ball;
  const double second = ball.summit() * ball.restitution * ball.restitution;
  const double time = ball.impact_time(0) + ball.impact_speed(1) / Ball::gravity;
  for (const bool high : {true, false}) {
    const auto limited = [&](double limit) {
      return with(ball.scene(), set::rule(CountRule::peaks), set::peak_high(high ? limit : 100),
                  set::peak_low(high ? 1e-6 : limit));
    };
    expect_doubt(limited(second * (1 + 1e-10)), Doubt::margin,
                 fmt::format("a maximum at {:.6g} s is within {:.2g} m of", time, 1e-10 * second));
    EXPECT_NEAR(*certainty(limited(second * (1 + 1e-10))).margin, 1e-10, 1e-14);
    EXPECT_TRUE(certainty(limited(second * (1 + 1e-10) * (1 - 1e-7))).certain);
  }
}

TEST(Certainty, DoubtsAnImpactAtTheEndOfTheWindow) {
  const Ball ball;
  const Scene scene = with(ball.scene(), set::counting_limit(0.1));
  for (int k = 0; k < 5; ++k) {
    const double time = ball.impact_time(k);
    for (const double off : {1e-12, -1e-12, 1e-15, -1e-15, 0.0}) {
      expect_doubt(with(scene, set::seconds(time * (1 + off))), Doubt::window,
                   "s of the end of the window");
      EXPECT_TRUE(certainty(with(scene, set::seconds(time * (1 + 1e6 * off) + 1e-6))).certain);
    }
  }
}

TEST(Certainty, TellsTheNearestMissedWall) {
  const Ball ball;
  for (const double miss : {1e-2, 1e-5, 1e-8}) {
    const double wall = ball.summit() + miss;
    const Scene up = with(ball.scene(), set::wall_upper(wall));
    const Scene down =
        with(up, set::walls(-wall, 0), set::pull(-up.pull), set::start_velocity(-ball.speed));
    for (const auto& [scene, side] : {std::pair{up, Wall::upper}, {down, Wall::lower}}) {
      const Certainty found = certainty(scene);
      ASSERT_TRUE(found.graze);
      EXPECT_EQ(found.graze->wall, side);
      EXPECT_NEAR(found.graze->distance, miss, 1e-12);
      EXPECT_NEAR(found.graze->time, ball.speed / Ball::gravity, 1e-12);
    }
    EXPECT_TRUE(certainty(up).certain) << "a touch would be too slow to count";
  }
}

TEST(Certainty, DoubtsAWallThatIsJustMissedWhereTouchesCount) {
  const Ball ball;
  const Scene scene = with(ball.scene(), set::counting_limit(1e-6), set::seconds(1));
  for (const double miss : {3e-12, -3e-12, 0.0}) {
    const Scene near = with(scene, set::wall_upper(ball.summit() + miss));
    const Certainty close = certainty(near);
    // After a touch the nearest miss is that of a later, lower hop.
    const bool missed = close.graze->distance < 1e-6;
    expect_doubt(near, Doubt::graze,
                 fmt::format("at {:.6g} s the carrier {} the upper wall",
                             ball.speed / Ball::gravity, missed ? "misses" : "touches"));
    if (miss == 0) continue;
    EXPECT_EQ(missed, miss > 0);
    if (missed) {
      EXPECT_NEAR(close.graze->distance, miss, 1e-12);
    }
    EXPECT_TRUE(certainty(with(scene, set::wall_upper(ball.summit() + 1e6 * miss))).certain);
  }
}

/// A mass shaken hard in a gap, with walls that take little: each impact widens differences.
Scene chaotic_gap(double seconds) {
  return with(Scene{}, set::wall_upper(2e-3), set::restitution(0.9), set::pull(0.3),
              set::disturbance(4), set::disturbance_frequency(40), set::start(0.7e-3, 0.03),
              set::counting_limit(0.05), set::seconds(seconds));
}

TEST(Certainty, GrowsAsTheDerivativesDo) {
  using Jet = ceres::Jet<double, 8>;
  double largest = 0;
  for (const double seconds : {0.2, 0.5, 1.0}) {
    const Scene scene = chaotic_gap(seconds);
    BasicScene<Jet> dual = lifted<Jet>(scene);
    int i = 0;
    for (Jet* x :
         {&dual.mass, &dual.wall_upper, &dual.restitution_lower, &dual.restitution_upper,
          &dual.pull, &dual.disturbance, &dual.disturbance_frequency, &dual.start_velocity}) {
      x->v[i++] = x->a;  // of a relative change
    }
    // The change of ln(speed), where all constants work together.
    double bound = 0;
    for (const auto& hit : watch(dual).hits) {
      if (hit.speed.a < scene.counting_limit) continue;
      bound = std::max(bound, hit.speed.v.lpNorm<1>() / hit.speed.a);
    }
    const Certainty gap = certainty(scene);
    EXPECT_TRUE(gap.certain) << gap.reason;
    EXPECT_LT(gap.growth, 3 * bound);  // of the start and the lower wall, too
    EXPECT_GT(gap.growth, 0.1 * bound);
    largest = std::max(largest, gap.growth);
  }
  EXPECT_GT(largest, 100);
}

TEST(Certainty, DoubtsAPathThatHasLostItsDigits) {
  const double growth = certainty(chaotic_gap(60)).growth;
  EXPECT_GE(growth, 1e6);
  expect_doubt(chaotic_gap(60), Doubt::sensitive, fmt::format("grows {:.2g}-fold by ", growth));
}

TEST(Certainty, DoubtsMaximaWithoutAnEnd) {
  const Scene scene = with(Ball{}.scene(), set::rule(CountRule::peaks), set::peak_high(0.1),
                           set::peak_low(1e-9), set::seconds(10));
  expect_doubt(scene, Doubt::endless, "maxima count that never end");
  EXPECT_TRUE(certainty(with(scene, set::seconds(2.2))).certain) << "before the last of them";
}

TEST(Certainty, DoubtsWallsThatAreOneButForTheTenthDigit) {
  const Scene narrow = with(Ball{}.scene(), set::walls(1, 1 + 1e-13), set::start_position(1));
  EXPECT_FALSE(certainty(narrow).certain);
  EXPECT_THAT(certainty(narrow).reason, HasSubstr("one wall crosses the other"));
  const Scene across =
      with(Ball{}.scene(),
           set::planar({.wall_lower = 1.0, .wall_upper = 1.0 + 1e-13, .start_position = 1.0}));
  EXPECT_THAT(certainty(across).reason, HasSubstr("one wall crosses the other"));
}

TEST(Certainty, DoubtsNumbersThatOverflow) {
  const Scene scene = Ball{}.scene();
  FeatureTrace trace(scene);
  trace.impact(0.25, Wall::lower, 1.0);
  EXPECT_TRUE(trace.finite());
  trace.impact(0.5, Wall::lower, quiet_nan);
  EXPECT_FALSE(trace.finite());
  Neighbours neighbours(scene);
  const Certainty lost = certainty_of(scene, trace, neighbours);
  EXPECT_FALSE(lost.certain);
  EXPECT_EQ(lost.reason, "numbers overflow");
}

TEST(Certainty, SpeaksOfCompliantWallsToo) {
  const Ball ball;
  const Scene scene = with(ball.scene(), set::fidelity(Fidelity::compliant), set::seconds(1),
                           set::wall_upper(ball.summit() + 1e-5));
  const Certainty plain = certainty(scene);
  EXPECT_TRUE(plain.certain) << plain.reason;
  EXPECT_NEAR(plain.graze->distance, 1e-5, 1e-12);
  // Of the first return.
  EXPECT_EQ(certainty(with(scene, set::counting_limit(ball.speed * (1 + 1e-12)))).doubt,
            Doubt::margin);
}

TEST(Certainty, OfFewConstantsIsNotBlind) {
  // A free body between elastic walls knows neither mass nor forces. The second impact is at 3 s.
  const Scene scene = with(Scene{}, set::start_velocity(0.5), set::seconds(3.2));
  const Scene counted = with(scene, set::counting_limit(0.1));
  EXPECT_EQ(certainty(with(scene, set::counting_limit(0.5 * (1 - 1e-12)))).doubt, Doubt::margin);
  EXPECT_TRUE(certainty(counted).certain);
  EXPECT_EQ(certainty(with(counted, set::seconds(3))).doubt, Doubt::window);
}

/// Whether a change of one constant in the twelfth digit changes the count.
bool flips(const Scene& scene) {
  const double given = objective(scene, 0.0);
  const auto flips_by = [&](const auto& change) {
    return std::ranges::any_of(std::array{1 + 1e-12, 1 - 1e-12}, [&](double factor) {
      Scene near = scene;
      change(near, factor);
      return objective(near, 0.0) != given;
    });
  };
  for (double Scene::*const x :
       {&Scene::mass, &Scene::friction, &Scene::normal_force, &Scene::pull,
        &Scene::centrifugal_mass_radius, &Scene::slider_mass_radius, &Scene::phase,
        &Scene::disturbance, &Scene::disturbance_frequency, &Scene::start_velocity, &Scene::omega,
        &Scene::counting_limit, &Scene::peak_high, &Scene::peak_low}) {
    if (flips_by([x](Scene& s, double factor) { s.*x *= factor; })) return true;
  }
  for (double Scene::*const x : {&Scene::restitution_lower, &Scene::restitution_upper}) {
    if (flips_by([x](Scene& s, double factor) { s.*x = std::min(1.0, s.*x * factor); }))
      return true;
  }
  // A body that starts on a wall stays on it.
  for (double Scene::*const wall : {&Scene::wall_lower, &Scene::wall_upper}) {
    if (flips_by([&](Scene& s, double factor) {
          const bool held = s.start_position == s.*wall;
          s.*wall *= factor;
          if (held) s.start_position = s.*wall;
        })) {
      return true;
    }
  }
  const bool on_a_wall =
      scene.start_position == scene.wall_lower || scene.start_position == scene.wall_upper;
  return (!on_a_wall && flips_by([](Scene& s, double factor) { s.start_position *= factor; })) ||
         flips_by([](Scene& s, double factor) {
           std::visit([&](auto& window) { window.count *= factor; }, s.window);
         });
}

TEST(Certainty, SurvivesEveryChangeOfOneConstant) {
  RandomScenes scenes(11);
  int certain = 0;
  int caught = 0;
  for (int i = 0; i < 2000; ++i) {
    Scene scene = scenes.next();
    // Every other scene has its limit, or the end of its window, at one of its impacts.
    const auto hits = watch(scene).hits;
    if (i % 2 == 1 && !hits.empty()) {
      const auto& hit =
          hits[static_cast<std::size_t>(scenes.within(0, 1) * static_cast<double>(hits.size()))];
      const double off = 1 + scenes.within(-1e-12, 1e-12);
      if (i % 4 == 1 && hit.speed > 1e-6) scene.counting_limit = hit.speed * off;
      if (i % 4 == 3 && hit.time > 1e-3) scene.window = Seconds{hit.time * off};
    }
    const Certainty found = certainty(scene);
    certain += found.certain ? 1 : 0;
    if (!flips(scene)) continue;
    EXPECT_FALSE(found.certain) << "scene " << i;
    ++caught;
  }
  EXPECT_GT(certain, 1000);
  EXPECT_GT(caught, 400);
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
  const Scene scene = with(Scene{}, set::start_velocity(0.5), set::restitution(0.5),
                           set::seconds(10), set::counting_limit(0.4));
  const Traced trace(scene);
  const auto& upper = trace.features(FeatureTrace::upper_impact);
  const auto& lower = trace.features(FeatureTrace::lower_impact);
  ASSERT_EQ(std::pair(upper.size(), lower.size()), std::pair(1UL, 1UL));
  EXPECT_DOUBLE_EQ(upper[0].time, 1.0);
  EXPECT_DOUBLE_EQ(upper[0].margin(), std::log(0.5 / 0.4));
  EXPECT_EQ(upper[0].scaled, upper[0].margin());
  EXPECT_DOUBLE_EQ(lower[0].time, 5.0);
  EXPECT_DOUBLE_EQ(lower[0].margin(), std::log(0.25 / 0.4));
  EXPECT_DOUBLE_EQ(lower[0].scaled, 0.25 / 0.4 - 1);  // too slow to count
  EXPECT_EQ(trace.impacts(Wall::upper).size(), 1U);
  EXPECT_EQ(trace.impacts(Wall::lower).size(), 1U);
  EXPECT_TRUE(trace.features(FeatureTrace::high_peak).empty());
  EXPECT_FALSE(trace.graze()) << "a wall that is hit is not missed";
}

TEST(FeatureTrace, KeepsEveryMaximumWithBothItsMargins) {
  const Traced trace(
      with(thrown_body(), set::rule(CountRule::peaks), set::peak_high(0.5), set::peak_low(0.5)));
  const auto& high = trace.features(FeatureTrace::high_peak);
  const auto& low = trace.features(FeatureTrace::low_peak);
  ASSERT_EQ(std::pair(high.size(), low.size()), std::pair(1UL, 1UL));
  EXPECT_NEAR(high[0].time, 0.5, 1e-12);
  EXPECT_NEAR(high[0].margin(), 0.25, 1e-12);
  EXPECT_NEAR(low[0].margin(), -0.25, 1e-12);
  EXPECT_NEAR(low[0].scaled, std::exp(-0.25) - 1, 1e-12);
  EXPECT_TRUE(trace.features(FeatureTrace::upper_impact).empty());
}

TEST(FeatureTrace, TellsOfMaximaWithoutAnEnd) {
  const Scene scene =
      with(thrown_body(), set::rule(CountRule::peaks), set::peak_high(0.5), set::peak_low(1e-3),
           set::restitution_lower(0.5), set::seconds(10), set::across(Across<double>{}));
  // Down from 0.625 m, and up again at half the speed, each time. They end after three falls.
  const double fall = std::sqrt(2 * 0.625);
  for (const Fidelity level : {Fidelity::impact, Fidelity::planar}) {
    const Traced trace(with(scene, set::fidelity(level)));
    ASSERT_TRUE(trace.endless());
    EXPECT_NEAR(trace.endless()->time, 0.5 + 3 * fall, 1e-8);
    EXPECT_EQ(trace.endless()->wall, Wall::lower);
  }
  const Scene planar = with(scene, set::fidelity(Fidelity::planar));
  EXPECT_FALSE(Traced(with(planar, set::wall_lower(0.125))).endless())
      << "none counts where the wall lies between the limits";
  EXPECT_FALSE(Traced(with(planar, set::restitution_lower(0))).endless())
      << "the body stays on the wall";
  EXPECT_FALSE(Traced(with(planar, set::seconds(0.5 + fall))).endless())
      << "there is an end before";
  // The other way up the maxima lie on the wall itself, which is high.
  EXPECT_TRUE(Traced(with(thrown_body(), set::rule(CountRule::peaks), set::pull(-1),
                          set::start_velocity(0), set::restitution_upper(0.5), set::seconds(10)))
                  .endless());
}

TEST(FeatureTrace, TellsOfSwingsInAWallWithoutAnEnd) {
  const Scene scene =
      with(thrown_body(), set::rule(CountRule::peaks), set::peak_high(0.5), set::peak_low(1e-3),
           set::restitution_lower(0.5), set::fidelity(Fidelity::compliant), set::stiffness(1e4));
  EXPECT_TRUE(Traced(with(scene, set::seconds(10))).endless());
  EXPECT_FALSE(Traced(scene).endless()) << "before it comes down";
}

TEST(FeatureTrace, KnowsAMaximumThatRoundingMakes) {
  // From rest by x'' = sin t: the speed 1 - cos t touches zero at every turn, and is never below.
  int told = 0;
  for (int i = 0; i < 20; ++i) {
    const Traced trace(with(Scene{}, set::wall_upper(100), set::rule(CountRule::peaks),
                            set::centrifugal_mass_radius(1), set::start_position(0),
                            set::seconds(30),
                            // It is released when the force has turned.
                            set::phase(-std::numbers::pi / 2 - 0.1 * i)));
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
      if (near.failure) {
        any_doubt = true;
        continue;
      }
      const FeatureComparison comparison(trace, duration_of(scene), near.trace, near.end);
      if (k % 2 == 0) one_side_is_clear = one_side_is_clear && comparison.is_clear();
      any_doubt = any_doubt || comparison.first().doubt != Doubt::none;
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
    const Scene limited = with(scene, set::counting_limit(share));
    const Traced trace(limited);
    const FeatureComparison comparison(trace, 1, trace, 1);
    EXPECT_EQ(comparison.first().doubt == Doubt::none, share < 1 - 1e-9) << share;
    EXPECT_EQ(comparison.is_clear(), share < 1 - 1e-7) << share;
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
