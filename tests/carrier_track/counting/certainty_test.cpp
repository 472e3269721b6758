#include "problems/carrier_track/counting/certainty.h"

#include <ceres/jet.h>

#include "problems/carrier_track/counting/count.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

using testing::DoubleNear;

Certainty certainty(const Scene& scene) {
  FeatureTrace trace(scene);
  Neighbours neighbours(scene);
  neighbours.simulate_with(scene, trace);
  return certainty_of(scene, trace, neighbours);
}

Certainty expect_doubt(const Scene& scene, Doubt doubt, const std::string& reason) {
  Certainty found = certainty(scene);
  EXPECT_FALSE(found.certain);
  EXPECT_EQ(found.doubt, doubt) << found.reason;
  EXPECT_THAT(found.reason, HasSubstr(reason));
  return found;
}

/// A ball thrown up from the lower wall; without an upper one it is back after 2 v / gravity.
namespace tossed {

constexpr double gravity = 9.8, speed = 3.0, restitution = 0.8;  // [m/s^2], [m/s]
constexpr double summit = speed * speed / (2 * gravity);         // [m]

/// Speed [m/s] and time [s] of the k-th return, from 0.
double impact_speed(int k) {
  return speed * std::pow(restitution, k);
}
double impact_time(int k) {
  return 2 * speed / gravity * (1 - std::pow(restitution, k + 1)) / (1 - restitution);
}

/// The window ends after the impact of k = 4.
const Scene scene = with(Scene{}, set::mass(1.3), set::pull(1.3 * gravity),
                         set::wall_upper(infinity), set::restitution(restitution),
                         set::start(0, speed), set::seconds(2.2), set::counting_limit(1));

}  // namespace tossed

TEST(Certainty, OfAPlainSceneIsCertainWithAGrowthOfOrderOne) {
  const Certainty plain = certainty(tossed::scene);
  EXPECT_TRUE(plain.certain);
  EXPECT_EQ(plain.doubt, Doubt::none);
  EXPECT_EQ(plain.reason, "");
  // ln(e^k v0) changes k times as much as e, and as much as v0.
  EXPECT_THAT(plain.growth, AllOf(testing::Gt(0.5), testing::Lt(7.0)));
  // The last is the nearest to the limit.
  EXPECT_NEAR(*plain.margin, std::log(tossed::impact_speed(4)), 1e-13);
  EXPECT_FALSE(plain.graze);  // there is no wall ahead
  const Certainty brief = certainty(with(tossed::scene, set::seconds(1e-4)));
  EXPECT_TRUE(brief.certain);
  EXPECT_FALSE(brief.margin) << "no features";
}

TEST(Certainty, DoubtsAnImpactAtTheSlowestSpeedAndAtTheEndOfTheWindow) {
  for (int k = 0; k < 5; ++k) {
    const auto limited = [&](double off) {
      return with(tossed::scene, set::counting_limit(tossed::impact_speed(k) * (1 + off)));
    };
    const auto ended = [&](double off, double later) {
      return with(tossed::scene, set::counting_limit(0.1),
                  set::seconds(tossed::impact_time(k) * (1 + off) + later));
    };
    for (const double off : {1e-12, -1e-12}) {
      const auto found =
          expect_doubt(limited(off), Doubt::margin,
                       fmt::format("an impact at {:.6g} s is w", tossed::impact_time(k)));
      EXPECT_NEAR(*found.margin, 1e-12, 1e-14);
    }
    EXPECT_TRUE(certainty(limited(1e-7)).certain);
    for (const double off : {1e-12, -1e-12, 1e-15, -1e-15, 0.0}) {
      expect_doubt(ended(off, 0), Doubt::window, "s of the end of the window");
      EXPECT_TRUE(certainty(ended(1e6 * off, 1e-6)).certain);
    }
  }
}

TEST(Certainty, DoubtsAMaximumAtALimit) {
  const double second = tossed::summit * tossed::restitution * tossed::restitution;
  const double time = tossed::impact_time(0) + tossed::impact_speed(1) / tossed::gravity;
  for (const bool high : {true, false}) {
    const auto limited = [&](double limit) {
      return with(tossed::scene, set::rule(CountRule::peaks), set::peak_high(high ? limit : 100),
                  set::peak_low(high ? 1e-6 : limit));
    };
    const auto found = expect_doubt(
        limited(second * (1 + 1e-10)), Doubt::margin,
        fmt::format("a maximum at {:.6g} s is within {:.2g} m of", time, 1e-10 * second));
    EXPECT_NEAR(*found.margin, 1e-10, 1e-14);
    EXPECT_TRUE(certainty(limited(second * (1 + 1e-10) * (1 - 1e-7))).certain);
  }
}

TEST(Certainty, DoubtsAMaximumThatRoundingMakes) {
  // From rest by x'' = sin t: the speed 1 - cos t touches zero at every turn, and is never below.
  int doubted = 0;
  for (int i = 0; i < 20; ++i) {
    const Certainty found = certainty(with(
        Scene{}, set::wall_upper(100), set::rule(CountRule::peaks), set::centrifugal_mass_radius(1),
        set::start_position(0), set::seconds(30), set::phase(-std::numbers::pi / 2 - 0.1 * i)));
    if (found.doubt == Doubt::graze && found.reason.find("a maximum") == 0) ++doubted;
  }
  EXPECT_GT(doubted, 0);
}

TEST(Certainty, TellsTheNearestMissedWall) {
  for (const double miss : {1e-2, 1e-5, 1e-8}) {
    const double wall = tossed::summit + miss;
    const Scene up = with(tossed::scene, set::wall_upper(wall));
    const Scene down =
        with(up, set::walls(-wall, 0), set::pull(-up.pull), set::start_velocity(-tossed::speed));
    for (const auto& [scene, side] : {std::pair{up, Wall::upper}, {down, Wall::lower}}) {
      EXPECT_THAT(certainty(scene).graze.value(),
                  FieldsAre(DoubleNear(tossed::speed / tossed::gravity, 1e-12), side,
                            DoubleNear(miss, 1e-12)));
    }
    EXPECT_TRUE(certainty(up).certain) << "a touch would be too slow to count";
  }
}

TEST(Certainty, DoubtsAWallThatIsJustMissedWhereTouchesCount) {
  const Scene scene = with(tossed::scene, set::counting_limit(1e-6), set::seconds(1));
  for (const double miss : {3e-12, -3e-12, 0.0}) {
    const Scene near = with(scene, set::wall_upper(tossed::summit + miss));
    const Certainty close = certainty(near);
    // After a touch the nearest miss is that of a later, lower hop.
    const bool missed = close.graze->distance < 1e-6;
    expect_doubt(near, Doubt::graze,
                 fmt::format("at {:.6g} s the carrier {} the upper wall",
                             tossed::speed / tossed::gravity, missed ? "misses" : "touches"));
    if (miss == 0) continue;
    EXPECT_EQ(missed, miss > 0);
    if (missed) {
      EXPECT_NEAR(close.graze->distance, miss, 1e-12);
    }
    EXPECT_TRUE(certainty(with(scene, set::wall_upper(tossed::summit + 1e6 * miss))).certain);
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

TEST(Certainty, DoubtsNumbersThatOverflow) {
  FeatureTrace trace(tossed::scene);
  trace.impact(0.25, Wall::lower, 1.0);
  EXPECT_TRUE(trace.finite());
  trace.impact(0.5, Wall::lower, quiet_nan);
  EXPECT_FALSE(trace.finite());
  Neighbours neighbours(tossed::scene);
  const Certainty lost = certainty_of(tossed::scene, trace, neighbours);
  EXPECT_FALSE(lost.certain);
  EXPECT_EQ(lost.reason, "numbers overflow");
}

TEST(Certainty, SpeaksOfCompliantWallsToo) {
  const Certainty plain = certainty(with(tossed::scene, set::fidelity(Fidelity::compliant),
                                         set::seconds(1), set::wall_upper(tossed::summit + 1e-5)));
  EXPECT_TRUE(plain.certain) << plain.reason;
  EXPECT_NEAR(plain.graze->distance, 1e-5, 1e-12);
}

TEST(Certainty, IsDoubtedOfTheseScenesAndNotOfThoseBeside) {
  // A free body between elastic walls knows neither mass nor forces. The second impact is at 3 s.
  const Scene free = with(Scene{}, set::start_velocity(0.5), set::seconds(3.2));
  const Scene compliant = with(tossed::scene, set::fidelity(Fidelity::compliant), set::seconds(1));
  const Scene peaks =
      with(tossed::scene, set::rule(CountRule::peaks), set::peak_high(0.1), set::peak_low(1e-9));
  struct Row {
    Scene doubtful;
    Doubt doubt;
    std::string reason;
    Scene beside;
  };
  for (const auto& [doubtful, doubt, reason, beside] :
       {Row{with(peaks, set::seconds(10)), Doubt::endless, "maxima count that never end", peaks},
        {with(compliant, set::counting_limit(tossed::speed * (1 + 1e-12))), Doubt::margin, "",
         compliant},
        {with(free, set::counting_limit(0.5 * (1 - 1e-12))), Doubt::margin, "", free},
        {with(free, set::counting_limit(0.1), set::seconds(3)), Doubt::window, "",
         with(free, set::counting_limit(0.1))},
        {with(tossed::scene, set::walls(1, 1 + 1e-13), set::start_position(1)), Doubt::sensitive,
         "one wall crosses the other", tossed::scene},
        {with(tossed::scene,
              set::planar({.wall_lower = 1.0, .wall_upper = 1 + 1e-13, .start_position = 1})),
         Doubt::sensitive, "one wall crosses the other", tossed::scene}}) {
    expect_doubt(doubtful, doubt, reason);
    EXPECT_TRUE(certainty(beside).certain) << "beside a doubt " << static_cast<int>(doubt);
  }
}

/// Whether a change of one constant in the twelfth digit changes the count. A body that starts on a
/// wall stays on it.
bool flips(const Scene& scene) {
  const double given = objective(scene, 0.0);
  const auto flips_by = [&](const auto& change) {
    return std::ranges::any_of(std::array{1 + 1e-12, 1 - 1e-12}, [&](double factor) {
      Scene near = scene;
      change(near, factor);
      near.restitution_lower = std::min(1.0, near.restitution_lower);
      near.restitution_upper = std::min(1.0, near.restitution_upper);
      if (scene.start_position == scene.wall_lower) near.start_position = near.wall_lower;
      if (scene.start_position == scene.wall_upper) near.start_position = near.wall_upper;
      return objective(near, 0.0) != given;
    });
  };
  for (double Scene::*const x :
       {&Scene::mass, &Scene::friction, &Scene::normal_force, &Scene::pull,
        &Scene::centrifugal_mass_radius, &Scene::slider_mass_radius, &Scene::phase,
        &Scene::disturbance, &Scene::disturbance_frequency, &Scene::start_velocity, &Scene::omega,
        &Scene::counting_limit, &Scene::peak_high, &Scene::peak_low, &Scene::restitution_lower,
        &Scene::restitution_upper, &Scene::wall_lower, &Scene::wall_upper,
        &Scene::start_position}) {
    if (flips_by([x](Scene& s, double factor) { s.*x *= factor; })) return true;
  }
  return flips_by([](Scene& s, double factor) {
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
          hits.at(static_cast<std::size_t>(scenes.within(0, 1) * static_cast<double>(hits.size())));
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
