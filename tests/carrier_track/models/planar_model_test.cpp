#include "problems/carrier_track/motion/planar_model.h"

#include "problems/carrier_track/check/random_scenes.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

using std::numbers::pi;

using Hit = Watched<double>::Hit;

/// Expects the same bits in x as of the impact model.
void expect_same_as_in_x_alone(const Scene& scene, const Watched<double>& actual) {
  const auto expected = watch(with(scene, set::fidelity(Fidelity::impact)));
  expect_hits(actual.hits, expected.hits, 0, 0);
  ASSERT_EQ(actual.tops.size(), expected.tops.size());
  for (std::size_t k = 0; k < actual.tops.size(); ++k) {
    ASSERT_EQ(actual.tops[k].time, expected.tops[k].time) << k;
    ASSERT_EQ(actual.tops[k].position, expected.tops[k].position) << k;
  }
  EXPECT_DOUBLE_EQ(actual.end.time, expected.end.time);
  EXPECT_EQ(actual.end.position, expected.end.position);
  EXPECT_EQ(actual.end.velocity, expected.end.velocity);
}

TEST(PlanarModel, WithoutFrictionMovesInXAsTheImpactModelBitForBit) {
  std::size_t across = 0;
  for_random(51, 300, [&](RandomScenes& draws) {
    const Scene scene = with(draws.next_planar(), set::friction(0));
    const auto watched = watch(scene);
    expect_same_as_in_x_alone(scene, watched);
    across += watched.across.size();
  });
  EXPECT_GT(across, 3000U) << "y must be lively, to show that it does not matter";
}

TEST(PlanarModel, WithABodyHeldInYMovesInXAsTheImpactModelBitForBit) {
  for_random(52, 300, [](RandomScenes& draws) {
    Scene scene = with(draws.next_planar(), set::slider_mass_radius(0), set::pull_rotates(false),
                       set::disturbance_frequency(draws.within(1, 30)));
    scene.across = Across<double>{.pull = 0.5 * scene.friction * scene.normal_force};
    expect_same_as_in_x_alone(scene, watch(scene));
  });
}

TEST(ObserverPair, TellsBothWhatOneAloneIsTold) {
  std::size_t across = 0;
  for_random(53, 30, [&](RandomScenes& draws) {
    const Scene scene = draws.next_planar();
    const auto alone = watch(scene);
    Watched<double> first, second;
    ObserverPair both(first, second);
    simulate(scene, both);
    for (const Watched<double>& each : {first, second}) {
      expect_hits(each.hits, alone.hits, 0, 0);
      expect_hits(each.across, alone.across, 0, 0);
      ASSERT_EQ(each.tops.size(), alone.tops.size());
    }
    across += alone.across.size();
  });
  EXPECT_GT(across, 300U);
}

/// The directions exchanged: x is what y was, and y is what x was, seen in a mirror, for then the
/// forces of the driver plate, -cos and sin, are those a quarter turn on.
Scene exchanged(const Scene& scene) {
  const Across<double>& y = *scene.across;
  return with(
      scene, set::phase(scene.phase + pi / 2), set::pull(scene.pull_rotates ? scene.pull : -y.pull),
      set::walls(y.wall_lower, y.wall_upper), set::restitution_lower(y.restitution_lower),
      set::restitution_upper(y.restitution_upper), set::start(y.start_position, y.start_velocity),
      set::across(Across<double>{scene.pull_rotates ? 0 : scene.pull, -scene.wall_upper,
                                 -scene.wall_lower, scene.restitution_upper,
                                 scene.restitution_lower, -scene.start_position,
                                 -scene.start_velocity}));
}

TEST(PlanarModel, ExchangingTheDirectionsExchangesTheMotion) {
  const auto expect_first = [](std::vector<Hit> actual, std::vector<Hit> expected, bool mirrored) {
    actual = distinct(actual);
    expected = distinct(expected);
    // Rounding alone tells them apart, and impacts make it grow.
    expected.resize(std::min<std::size_t>(12, expected.size()));
    actual.resize(std::min(actual.size(), expected.size()));
    expect_hits(actual, expected, 1e-8, 1e-8, mirrored);
  };
  std::size_t hits = 0;
  for_random(57, 300, [&](RandomScenes& draws) {
    Scene scene = with(draws.next_planar(), set::centrifugal_mass_radius(0), set::disturbance(0));
    scene.wall_upper = std::min(scene.wall_upper, scene.wall_lower + 5e-3);
    const auto one = watch(scene);
    const auto other = watch(exchanged(scene));
    expect_first(other.across, one.hits, true);
    expect_first(other.hits, one.across, false);
    hits += one.hits.size();
  });
  EXPECT_GT(hits, 1000U);
}

TEST(PlanarModel, TellsStretchesOfXThatFollowOnEachOther) {
  for_random(58, 300, [](RandomScenes& draws) {
    const Scene scene = draws.next_planar();
    const auto watched = watch(scene);
    double time = 0;
    Motion<double> last{scene.start_position, scene.start_velocity, 0};
    for (const auto& stretch : watched.stretches) {
      ASSERT_NEAR(stretch.time, time, 1e-14);
      ASSERT_NEAR(stretch.flight.position, last.position, 1e-13);
      const auto struck = [&](const Hit& hit) { return hit.time == stretch.time; };
      if (std::ranges::none_of(watched.hits, struck) &&
          std::ranges::none_of(watched.across, struck)) {
        ASSERT_NEAR(stretch.flight.velocity, last.velocity, 1e-14);
      }
      ASSERT_LE(std::abs(stretch.flight.velocity), std::abs(last.velocity) + 1e-14);
      time = stretch.time + stretch.duration;
      last = stretch.flight.at(stretch.duration);
      ASSERT_GE(last.position, scene.wall_lower - 1e-14);
      ASSERT_LE(last.position, scene.wall_upper + 1e-14);
    }
    EXPECT_NEAR(time, watched.end.time, 1e-14);
    EXPECT_NEAR(last.position, watched.end.position, 1e-13);
  });
}

TEST(PlanarModel, ASpinUpThrowsTheBodyAcrossByTheSlidersInertia) {
  // y'' = -s (omega' cos alpha - omega^2 sin alpha) / m is the second derivative of -s sin(alpha) /
  // m.
  const auto watched = watch(
      with(Scene{}, set::mass(1.3), set::slider_mass_radius(0.4), set::phase(0.7),
           set::profile(std::vector<SpeedKnot<double>>{{0.1, 1.0}, {2.1, 9.0}}), set::seconds(2.1),
           set::walls(-100, 100), set::planar({.wall_lower = -100, .wall_upper = 0.8})));
  ASSERT_GE(watched.across.size(), 1U);
  const double t = watched.across[0].time;
  const double share = 0.4 / 1.3;
  const double since = std::max(0.0, t - 0.1);
  const double alpha = 0.7 + t + 2.0 * since * since;
  const double y = 0.5 - share * (std::sin(alpha) - std::sin(0.7)) + share * std::cos(0.7) * t;
  EXPECT_NEAR(y, 0.8, 1e-13);
  EXPECT_GT(t, 0.1);
}

/// Far from the walls of x, pressed to the upper wall of y for good, under a slider force that acts
/// on both.
Scene pressed_by_a_turning_force() {
  return with(Scene{}, set::mass(0.8), set::walls(-100, infinity), set::start_position(0),
              set::friction(0.3), set::normal_force(0.2), set::omega(3),
              set::slider_mass_radius(0.1), set::planar({.pull = 1.5, .start_position = 1}));
}

TEST(PlanarFriction, ABodyHeldByAVaryingPressSlipsWhereTheForceLeavesItsBand) {
  // With S = slider_mass_radius omega^2, the force is -S cos a, the press P + S sin a. It slips up
  // where -S (cos a + mu sin a) = mu (N + P), down where -S (cos a - mu sin a) = -mu (N + P).
  const double mu = 0.3;
  const double limit = mu * (0.2 + 1.5) / (0.9 * std::hypot(1, mu));
  const double up = std::acos(-limit) + std::atan(mu);
  const double down = 2 * pi - std::acos(limit) - std::atan(mu);
  for (const bool rises : {true, false}) {
    const double phase = rises ? pi / 2 : 4.6;  // held at the start
    const auto stretches =
        watch(with(pressed_by_a_turning_force(), set::phase(phase), set::seconds(1.2))).stretches;
    ASSERT_GE(stretches.size(), 2U);
    EXPECT_NEAR(stretches[1].time, ((rises ? up : down) - phase) / 3, 1e-12);
    EXPECT_EQ(stretches[0].flight.velocity, 0.0);
    EXPECT_EQ(stretches[1].flight.at(1e-3).velocity > 0, rises);
  }
}

TEST(PlanarFriction, TheDisturbanceOfAPressSlowsTheOtherDirection) {
  // x is pressed by P - D cos(w t), which slows y by mu (N + P - D cos(w t)) / m.
  const auto watched =
      watch(with(pressed_by_a_turning_force(), set::slider_mass_radius(0), set::wall_lower(0),
                 set::pull(2), set::disturbance(1.1), set::disturbance_frequency(5),
                 set::planar({.start_position = 0, .start_velocity = 2})));
  ASSERT_GE(watched.across.size(), 1U);
  const double t = watched.across[0].time;
  const double share = 0.3 / 0.8;
  EXPECT_NEAR(2 * t - share * (2.2 * t * t / 2 - 1.1 * (1 - std::cos(5 * t)) / 25), 1, 1e-14);
  EXPECT_NEAR(watched.across[0].speed, 2 - share * (2.2 * t - 1.1 * std::sin(5 * t) / 5), 1e-14);
  EXPECT_EQ(watched.end.position, 0);
}

/// The impacts in x and y until `end` of a free body that loses speed along the walls by their
/// friction alone: straight lines between the walls of the unit square.
std::array<std::vector<Hit>, 2> billiard(const Scene& scene, double end) {
  struct Side {
    double restitution_lower, restitution_upper, position, velocity;
  };
  const Across<double>& y = *scene.across;
  Side sides[] = {{scene.restitution_lower, scene.restitution_upper, scene.start_position,
                   scene.start_velocity},
                  {y.restitution_lower, y.restitution_upper, y.start_position, y.start_velocity}};
  std::array<std::vector<Hit>, 2> hits;
  for (double time = 0;;) {
    std::array<double, 2> left{};
    for (std::size_t i = 0; i < 2; ++i) {
      const Side& s = sides[i];
      left[i] = s.velocity == 0 ? infinity : ((s.velocity > 0) - s.position) / s.velocity;
    }
    const std::size_t i = left[0] < left[1] ? 0 : 1;
    if (time + left[i] > end) return hits;
    time += left[i];
    Side& struck = sides[i];
    Side& other = sides[1 - i];
    other.position += other.velocity * left[i];
    const bool up = struck.velocity > 0;
    const double speed = std::abs(struck.velocity);
    hits[i].push_back({time, up ? Wall::upper : Wall::lower, speed});
    struck.position = up;
    const double e = up ? struck.restitution_upper : struck.restitution_lower;
    struck.velocity *= -e;
    const double taken = std::min(std::abs(other.velocity), scene.friction * (1 + e) * speed);
    other.velocity -= std::copysign(taken, other.velocity);
  }
}

TEST(PlanarFriction, AFreeBodyLosesItsSpeedToTheWallsAsInABilliard) {
  std::size_t hits = 0;
  int stopped = 0;
  for_random(55, 300, [&](RandomScenes& draws) {
    const auto within = [&](double a, double b) { return draws.within(a, b); };
    const Scene scene = with(
        Scene{}, set::restitution_lower(within(0.2, 1)), set::restitution_upper(within(0.2, 1)),
        set::start(within(0.1, 0.9), within(-2, 2)), set::friction(within(0, 0.1)), set::seconds(5),
        set::planar({.restitution_lower = within(0.2, 1),
                     .restitution_upper = within(0.2, 1),
                     .start_position = within(0.1, 0.9),
                     .start_velocity = within(-2, 2)}));
    const auto [in_x, in_y] = billiard(scene, 5);
    const auto watched = watch(scene);
    expect_hits(watched.hits, in_x, 1e-11, 1e-11);
    expect_hits(watched.across, in_y, 1e-11, 1e-11);
    hits += watched.hits.size();
    stopped += watched.end.velocity == 0;
  });
  EXPECT_GT(hits, 600U);
  EXPECT_GT(stopped, 5) << "an impulse takes no more than all speed";
}

/// A direction 1 m wide with friction of half the press in the other.
PlanarAxis<> axis_of(const Scene& scene) {
  return PlanarAxis<>(AppliedForces<double>(scene), {0, 1, 0.5, 0.5, scene.start_position, 0},
                      {0.5, 0}, 10.0, resting_speed);
}

TEST(PlanarAxis, AnImpulseDoesNotMoveItFromRest) {
  Observer nobody;
  PlanarAxis<> axis = axis_of(Scene{});
  axis.go_on(0, axis_of(Scene{}), nobody);
  axis.apply_friction_impulse(0.5, 3.0, nobody);
  EXPECT_FALSE(axis.go_on(0.5, axis_of(Scene{}), nobody));
  EXPECT_EQ(axis.next(), infinity);
}

TEST(PlanarAxis, IsHeldWhereForceAndFrictionBalanceButForRounding) {
  // A press of 0.1 i - 0.1 k gives friction of half that, which the pull equals in decimals.
  Observer nobody;
  for (int i = 2; i < 30; ++i) {
    for (int k = 1; k < i; ++k) {
      for (const double mass : {1.0, 1.2, 3.0}) {
        const Scene scene =
            with(Scene{}, set::mass(mass), set::omega(0), set::pull(0.05 * (i - k)));
        PlanarAxis<> other =
            axis_of(with(scene, set::disturbance_frequency(0), set::start_position(1),
                         set::pull(-0.1 * i), set::disturbance(-0.1 * k)));
        PlanarAxis<> axis = axis_of(scene);
        other.go_on(0, axis, nobody);
        axis.go_on(0, other, nobody);
        EXPECT_EQ(axis.finish(nobody).velocity, 0);
      }
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
