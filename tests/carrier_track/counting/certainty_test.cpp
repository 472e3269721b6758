#include "problems/carrier_track/counting/certainty.h"

#include <ceres/jet.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <variant>
#include <vector>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/models/watch.h"

namespace ricochet::carrier_track {
namespace {

using testing::HasSubstr;

constexpr double gravity = 9.8;  // [m/s^2]

Certainty certainty(const Scene& scene) {
  FeatureTrace trace(scene);
  Neighbours neighbours(scene);
  neighbours.simulate_with(scene, trace);
  return certainty_of(scene, trace, neighbours);
}

int count(const Scene& scene) {
  return static_cast<int>(objective(scene, 0.0));
}

/// A ball thrown up from the lower wall; without an upper one it is back after 2 v / gravity.
struct Ball {
  double speed = 3.0;  ///< [m/s]
  double restitution = 0.8;

  double summit() const { return speed * speed / (2 * gravity); }  ///< [m]

  /// Speed [m/s] and time [s] of the k-th return, from 0.
  double impact_speed(int k) const { return speed * std::pow(restitution, k); }
  double impact_time(int k) const {
    return 2 * speed / gravity * (1 - std::pow(restitution, k + 1)) / (1 - restitution);
  }

  Scene scene() const {
    Scene scene;
    scene.mass = 1.3;
    scene.pull = scene.mass * gravity;
    scene.wall_upper = std::numeric_limits<double>::infinity();
    scene.restitution_lower = scene.restitution_upper = restitution;
    scene.start_position = 0;
    scene.start_velocity = speed;
    scene.window = Seconds{2.2};  // ends after the impact of k = 4
    scene.counting_limit = 1.0;
    return scene;
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
    for (const double off : {1e-12, -1e-12}) {
      Scene scene = ball.scene();
      scene.counting_limit = ball.impact_speed(k) * (1 + off);
      const Certainty close = certainty(scene);
      EXPECT_FALSE(close.certain);
      EXPECT_EQ(close.doubt, Doubt::margin) << close.reason;
      EXPECT_NEAR(*close.margin, 1e-12, 1e-14);
      EXPECT_THAT(close.reason,
                  HasSubstr(fmt::format("an impact at {:.6g} s is within ", ball.impact_time(k))));
    }
    Scene scene = ball.scene();
    scene.counting_limit = ball.impact_speed(k) * (1 + 1e-7);
    EXPECT_TRUE(certainty(scene).certain);
  }
}

TEST(Certainty, DoubtsAMaximumAtALimit) {
  const Ball ball;
  const double second = ball.summit() * ball.restitution * ball.restitution;
  for (const bool high : {true, false}) {
    Scene scene = ball.scene();
    scene.rule = CountRule::peaks;
    scene.peak_high = high ? second * (1 + 1e-10) : 100;
    scene.peak_low = high ? 1e-6 : second * (1 + 1e-10);
    const Certainty close = certainty(scene);
    EXPECT_EQ(close.doubt, Doubt::margin) << close.reason;
    EXPECT_NEAR(*close.margin, 1e-10, 1e-14);
    const double time = ball.impact_time(0) + ball.impact_speed(1) / gravity;
    EXPECT_THAT(close.reason, HasSubstr(fmt::format("a maximum at {:.6g} s is within {:.2g} m of",
                                                    time, 1e-10 * second)));
    (high ? scene.peak_high : scene.peak_low) *= 1 - 1e-7;
    EXPECT_TRUE(certainty(scene).certain);
  }
}

TEST(Certainty, DoubtsAnImpactAtTheEndOfTheWindow) {
  const Ball ball;
  for (int k = 0; k < 5; ++k) {
    for (const double off : {1e-12, -1e-12, 1e-15, -1e-15, 0.0}) {
      Scene scene = ball.scene();
      scene.counting_limit = 0.1;
      scene.window = Seconds{ball.impact_time(k) * (1 + off)};
      const Certainty close = certainty(scene);
      EXPECT_EQ(close.doubt, Doubt::window) << close.reason;
      EXPECT_THAT(close.reason, HasSubstr("s of the end of the window"));
      scene.window = Seconds{ball.impact_time(k) * (1 + 1e6 * off) + 1e-6};
      EXPECT_TRUE(certainty(scene).certain);
    }
  }
}

TEST(Certainty, TellsTheNearestMissedWall) {
  const Ball ball;
  for (const double miss : {1e-2, 1e-5, 1e-8}) {
    Scene scene = ball.scene();
    scene.wall_upper = ball.summit() + miss;
    const Certainty up = certainty(scene);
    ASSERT_TRUE(up.graze);
    EXPECT_EQ(up.graze->wall, Wall::upper);
    EXPECT_NEAR(up.graze->distance, miss, 1e-12);
    EXPECT_NEAR(up.graze->time, ball.speed / gravity, 1e-12);
    EXPECT_TRUE(up.certain) << up.reason;  // a touch would be too slow to count
    // The same upside down.
    scene.pull = -scene.pull;
    scene.wall_lower = -scene.wall_upper;
    scene.wall_upper = 0;
    scene.start_velocity = -ball.speed;
    const Certainty down = certainty(scene);
    ASSERT_TRUE(down.graze);
    EXPECT_EQ(down.graze->wall, Wall::lower);
    EXPECT_NEAR(down.graze->distance, miss, 1e-12);
  }
}

TEST(Certainty, DoubtsAWallThatIsJustMissedWhereTouchesCount) {
  const Ball ball;
  for (const double miss : {3e-12, -3e-12, 0.0}) {
    Scene scene = ball.scene();
    scene.counting_limit = 1e-6;
    scene.window = Seconds{1.0};
    scene.wall_upper = ball.summit() + miss;
    const Certainty close = certainty(scene);
    EXPECT_FALSE(close.certain);
    EXPECT_EQ(close.doubt, Doubt::graze) << close.reason;
    // After a touch the nearest miss is that of a later, lower hop.
    const bool missed = close.graze->distance < 1e-6;
    EXPECT_THAT(close.reason,
                HasSubstr(fmt::format("at {:.6g} s the carrier {} the upper wall",
                                      ball.speed / gravity, missed ? "misses" : "touches")));
    if (miss == 0) continue;
    EXPECT_EQ(missed, miss > 0);
    if (missed) {
      EXPECT_NEAR(close.graze->distance, miss, 1e-12);
    }
    scene.wall_upper = ball.summit() + 1e6 * miss;
    EXPECT_TRUE(certainty(scene).certain);
  }
}

/// A mass shaken hard in a gap, with walls that take little: each impact widens differences.
Scene chaotic_gap() {
  Scene scene;
  scene.wall_upper = 2e-3;
  scene.restitution_lower = scene.restitution_upper = 0.9;
  scene.pull = 0.3;
  scene.disturbance = 4.0;
  scene.disturbance_frequency = 40.0;
  scene.start_position = 0.7e-3;
  scene.start_velocity = 0.03;
  scene.counting_limit = 0.05;
  return scene;
}

TEST(Certainty, GrowsAsTheDerivativesDo) {
  using Jet = ceres::Jet<double, 8>;
  double largest = 0;
  for (const double seconds : {0.2, 0.5, 1.0}) {
    Scene scene = chaotic_gap();
    scene.window = Seconds{seconds};
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
  Scene scene = chaotic_gap();
  scene.window = Seconds{60.0};
  const Certainty lost = certainty(scene);
  EXPECT_FALSE(lost.certain);
  EXPECT_EQ(lost.doubt, Doubt::sensitive) << lost.reason;
  EXPECT_GE(lost.growth, 1e6);
  EXPECT_THAT(lost.reason, HasSubstr(fmt::format("grows {:.2g}-fold by ", lost.growth)));
}

TEST(Certainty, DoubtsMaximaWithoutAnEnd) {
  Scene scene = Ball{}.scene();
  scene.rule = CountRule::peaks;
  scene.peak_high = 0.1;
  scene.peak_low = 1e-9;
  scene.window = Seconds{10.0};
  const Certainty endless = certainty(scene);
  EXPECT_FALSE(endless.certain);
  EXPECT_EQ(endless.doubt, Doubt::endless);
  EXPECT_THAT(endless.reason, HasSubstr("maxima count that never end"));
  scene.peak_low = 1e-9;
  scene.window = Seconds{2.2};  // before the last of them
  EXPECT_TRUE(certainty(scene).certain);
}

TEST(Certainty, DoubtsWallsThatAreOneButForTheTenthDigit) {
  Scene scene = Ball{}.scene();
  scene.wall_lower = scene.start_position = 1.0;
  scene.wall_upper = 1.0 + 1e-13;
  const Certainty narrow = certainty(scene);
  EXPECT_FALSE(narrow.certain);
  EXPECT_THAT(narrow.reason, HasSubstr("one wall crosses the other"));
  scene = Ball{}.scene();
  scene.fidelity = Fidelity::planar;
  scene.across.emplace();
  scene.across->wall_lower = scene.across->start_position = 1.0;
  scene.across->wall_upper = 1.0 + 1e-13;
  EXPECT_THAT(certainty(scene).reason, HasSubstr("one wall crosses the other"));
}

TEST(Certainty, DoubtsNumbersThatOverflow) {
  const Scene scene = Ball{}.scene();
  FeatureTrace trace(scene);
  trace.impact(0.5, Wall::lower, std::numeric_limits<double>::quiet_NaN());
  Neighbours neighbours(scene);
  const Certainty lost = certainty_of(scene, trace, neighbours);
  EXPECT_FALSE(lost.certain);
  EXPECT_EQ(lost.reason, "numbers overflow");
}

TEST(Certainty, SpeaksOfCompliantWallsToo) {
  const Ball ball;
  Scene scene = ball.scene();
  scene.fidelity = Fidelity::compliant;
  scene.window = Seconds{1.0};
  scene.wall_upper = ball.summit() + 1e-5;
  const Certainty plain = certainty(scene);
  EXPECT_TRUE(plain.certain) << plain.reason;
  EXPECT_NEAR(plain.graze->distance, 1e-5, 1e-12);
  scene.counting_limit = ball.speed * (1 + 1e-12);  // of the first return
  EXPECT_EQ(certainty(scene).doubt, Doubt::margin);
}

TEST(Certainty, OfFewConstantsIsNotBlind) {
  // A free body between elastic walls knows neither mass nor forces.
  Scene scene;
  scene.start_velocity = 0.5;
  scene.window = Seconds{3.2};
  scene.counting_limit = 0.5 * (1 - 1e-12);
  EXPECT_EQ(certainty(scene).doubt, Doubt::margin);
  scene.counting_limit = 0.1;
  EXPECT_TRUE(certainty(scene).certain);
  scene.window = Seconds{3.0};  // the second impact is at 3 s
  EXPECT_EQ(certainty(scene).doubt, Doubt::window);
}

/// Changes of one constant by a factor. A body that starts on a wall stays on it.
std::vector<std::function<void(Scene&, double)>> single_changes() {
  const auto move = [](double& wall, Scene& scene, double factor) {
    const bool held = scene.start_position == wall;
    wall *= factor;
    if (held) scene.start_position = wall;
  };
  std::vector<std::function<void(Scene&, double)>> changes;
  for (double Scene::*const x :
       {&Scene::mass, &Scene::friction, &Scene::normal_force, &Scene::pull,
        &Scene::centrifugal_mass_radius, &Scene::slider_mass_radius, &Scene::phase,
        &Scene::disturbance, &Scene::disturbance_frequency, &Scene::start_velocity, &Scene::omega,
        &Scene::counting_limit, &Scene::peak_high, &Scene::peak_low}) {
    changes.push_back([x](Scene& scene, double factor) { scene.*x *= factor; });
  }
  for (double Scene::*const x : {&Scene::restitution_lower, &Scene::restitution_upper}) {
    changes.push_back(
        [x](Scene& scene, double factor) { scene.*x = std::min(1.0, scene.*x * factor); });
  }
  changes.push_back([move](Scene& s, double factor) { move(s.wall_lower, s, factor); });
  changes.push_back([move](Scene& s, double factor) { move(s.wall_upper, s, factor); });
  changes.push_back([](Scene& s, double factor) {
    if (s.start_position == s.wall_lower || s.start_position == s.wall_upper) return;
    s.start_position *= factor;
  });
  changes.push_back([](Scene& s, double factor) {
    std::visit([&](auto& window) { window.count *= factor; }, s.window);
  });
  return changes;
}

/// Whether a change of one constant in the twelfth digit changes the count.
bool flips(const Scene& scene) {
  const int given = count(scene);
  for (const auto& change : single_changes()) {
    for (const double factor : {1 + 1e-12, 1 - 1e-12}) {
      Scene near = scene;
      change(near, factor);
      if (count(near) != given) return true;
    }
  }
  return false;
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

}  // namespace
}  // namespace ricochet::carrier_track
