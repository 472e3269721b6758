#include "problems/carrier_track/scene/scene_values.h"

#include <ceres/jet.h>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

using std::numbers::pi;

using PairDual = ceres::Jet<double, 2>;
using PairDualOfDuals = ceres::Jet<PairDual, 2>;
using Knots = std::vector<SpeedKnot<double>>;

TEST(Scalar, VanishesOnlyWithAllItsDerivatives) {
  EXPECT_TRUE(vanishes(0.0));
  EXPECT_FALSE(vanishes(1e-300));
  EXPECT_TRUE(vanishes(PairDual(0.0)));
  EXPECT_FALSE(vanishes(PairDual(0.0, 1)));
  EXPECT_FALSE(vanishes(PairDual(1.0)));
  PairDualOfDuals x = constant<PairDualOfDuals>(0.0);
  EXPECT_TRUE(vanishes(x));
  x.v[1].v[0] = 1;
  EXPECT_FALSE(vanishes(x));
  // It is constant without those of the outermost order.
  EXPECT_TRUE(is_constant(1.0));
  EXPECT_TRUE(is_constant(PairDual(1.0)));
  EXPECT_FALSE(is_constant(PairDual(1.0, 1)));
  EXPECT_TRUE(is_constant(PairDualOfDuals(PairDual(1.0, 1))));
}

TEST(Scalar, IsScaledWithAllItsDerivatives) {
  PairDualOfDuals x(PairDual(1.0, 0));
  x.v[1] = PairDual(3.0, 1);
  const PairDualOfDuals y = scaled(x, -2);
  EXPECT_EQ(std::tuple(y.a.a, y.a.v[0], y.v[1].a, y.v[1].v[1], y.v[0].a),
            std::tuple(-2, -2, -6, -2, 0));
}

TEST(Scalar, TakesAsManyNewtonStepsAsItHasOrders) {
  EXPECT_EQ(std::tuple(newton_steps<double>, newton_steps<long double>, newton_steps<PairDual>,
                       newton_steps<PairDualOfDuals>),
            std::tuple(0, 2, 1, 2));
}

TEST(Window, LastsItsSecondsOrTheAngleOfItsRevolutionsOverTheSpeed) {
  EXPECT_EQ(duration_of(with(Scene{}, set::seconds(7.25), set::profile(Knots{{0, 1}, {1, 9}}))),
            7.25);
  EXPECT_DOUBLE_EQ(duration_of(with(Scene{}, set::omega(4), set::revolutions(2.5))),
                   2.5 * 2 * pi / 4.0);
  EXPECT_NEAR(turns_of(with(Scene{}, set::omega(4 * pi), set::seconds(5))), 10, 1e-12);
  EXPECT_NEAR(turns_of(with(Scene{}, set::omega(4 * pi), set::revolutions(1.5))), 1.5, 1e-12);
}

/// The angle [rad] that a profile turns by in a time [s], from straight line to straight line.
double angle_turned(Knots profile, double until) {
  profile.insert(profile.begin(), {0.0, profile.front().omega});
  profile.push_back({1e9, profile.back().omega});
  double angle = 0;
  for (std::size_t k = 1; k < profile.size(); ++k) {
    const SpeedKnot<double>&from = profile[k - 1], &to = profile[k];
    const double time = std::clamp(until - from.time, 0.0, to.time - from.time);
    const double rise = (to.omega - from.omega) / (to.time - from.time);
    angle += time * (from.omega + rise * time / 2);
  }
  return angle;
}

TEST(Window, OfRevolutionsEndsWhenTheProfileHasTurnedSoFar) {
  std::mt19937_64 random(3);
  const auto within = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int before = 0, among = 0, after = 0;  // the knots
  for (int i = 0; i < 300; ++i) {
    Knots profile = {{within(0.0, 0.3), within(1, 9)}};
    for (int k = 0; k < 3; ++k) {
      profile.push_back({profile.back().time + within(0.05, 0.4), within(1, 9)});
    }
    const double turns = within(0.001, 1.0);
    const double end = duration_of(with(Scene{}, set::profile(profile), set::revolutions(turns)));
    EXPECT_NEAR(angle_turned(profile, end), 2 * pi * turns, 1e-13 * (1 + turns));
    ++(end < profile.front().time ? before : end < profile.back().time ? among : after);
  }
  EXPECT_GT(std::min({before, among, after}), 5);
}

TEST(Clearance, GrowsFromTheLowerWallAndTakesTheStartAlong) {
  const Scene wider = scaled_clearance(2.0, with(Scene{}, set::walls(1, 3), set::start(1.5, 0)));
  EXPECT_EQ(std::tuple(wider.wall_lower, wider.wall_upper, wider.start_position),
            std::tuple(1.0, 5.0, 2.0));
  EXPECT_EQ(scaled_clearance(0.9, with(Scene{}, set::wall_upper(infinity))).wall_upper, infinity);
}

const Scene resting_on_a_wall =
    with(Scene{}, set::mass(1.2), set::wall_upper(0.8e-3), set::start_position(0),
         set::restitution(0.5), set::friction(0.2), set::normal_force(11.8),
         set::centrifugal_mass_radius(0.078), set::revolutions(40));

/// Returns true if the carrier still turns or hits a wall in the second half of the window.
bool keeps_moving(const Scene& scene, double omega) {
  const Recording recording = record(at_speed(scene, omega), 0.25, 0);
  const auto is_late = [&](const auto& events) {
    return !events.empty() && events.back().time > 125 / omega;
  };
  return is_late(recording.impacts) || is_late(recording.peaks);
}

TEST(Release, FollowsTheHandFormula) {
  EXPECT_NEAR(release_speed(resting_on_a_wall).value(), std::sqrt(0.2 * 11.8 / 0.078), 1e-12);
  // The slider is against the carrier.
  const Scene pulled = with(resting_on_a_wall, set::slider_mass_radius(0.02), set::pull(0.5));
  for (const double disturbance : {0.0, 0.3}) {
    EXPECT_NEAR(release_speed(with(pulled, set::disturbance(disturbance))).value(),
                std::sqrt((0.2 * 11.8 + 0.5 - disturbance) / 0.058), 1e-12);
  }
}

TEST(Release, IsWhereTheCarrierBeginsToMove) {
  const Scene& scene = resting_on_a_wall;
  for (const Scene& each :
       {scene, with(scene, set::pull(-0.7)),  // to the upper wall
        with(scene, set::pull(0.7), set::pull_rotates(true), set::pull_phase(2)),
        with(scene, set::centrifugal(Centrifugal::outward), set::centrifugal_mass_radius(0.01),
             set::slider_mass_radius(0.05))}) {
    const double release = release_speed(each).value();
    EXPECT_FALSE(keeps_moving(each, 0.999 * release)) << release;
    EXPECT_TRUE(keeps_moving(each, 1.001 * release)) << release;
  }
  // At once, or never.
  const Scene shaken = with(scene, set::disturbance(3));
  EXPECT_EQ(release_speed(shaken), 0.0);
  const Scene pressed = with(shaken, set::disturbance_frequency(0));
  EXPECT_GT(release_speed(pressed).value(), 5);
  EXPECT_FALSE(release_speed(with(pressed, set::centrifugal(Centrifugal::inward))).has_value());
}

TEST(Release, ThrowsTheCarrierAcrossTheClearance) {
  EXPECT_EQ(thrown_speed(resting_on_a_wall, 5), 0);
  EXPECT_NEAR(thrown_speed(resting_on_a_wall, 10), std::sqrt(2 * (7.8 - 2.36) * 0.8e-3 / 1.2),
              1e-12);
  EXPECT_EQ(thrown_speed(with(resting_on_a_wall, set::wall_upper(infinity)), 10), infinity);
}

constexpr double golden = 0.6180339887498949;
constexpr double root_of_two = 0.4142135623730950;

/// A scene of which every constant is far from zero.
Scene full_scene() {
  Scene scene = with(Scene{}, set::mass(1.5), set::walls(0.5, 2), set::restitution_lower(0.25),
                     set::restitution_upper(0.5), set::friction(0.125), set::normal_force(3),
                     set::pull(-1.25), set::pull_phase(3.5), set::centrifugal_mass_radius(0.75),
                     set::slider_mass_radius(0.375), set::phase(0.25), set::disturbance(2.5),
                     set::disturbance_frequency(7), set::disturbance_phase(-0.5), set::start(1, -3),
                     set::omega(5), set::profile(Knots{{0, 4}, {1, 6}}), set::stiffness(1e7),
                     set::contact_speed(0.625));
  scene.across = Across<double>{1.75, -1.0, 3.0, 0.75, 0.625, 2.0, 0.875};
  return scene;
}

/// The constants that a perturbation changes, in the order in which it does, and what their change
/// is relative to.
std::vector<std::pair<double, double>> drawn(const Scene& s) {
  std::vector<std::pair<double, double>> all;
  const auto add = [&all](std::initializer_list<double> values, double relative_to = 0) {
    for (const double x : values) all.emplace_back(x, relative_to == 0 ? x : relative_to);
  };
  const Across<double>& y = s.across.value();
  add({s.mass});
  add({s.wall_lower, s.wall_upper, s.start_position}, 2);  // the largest coordinate
  add({s.restitution_lower, s.restitution_upper, s.friction, s.normal_force, s.pull,
       s.centrifugal_mass_radius, s.slider_mass_radius});
  add({s.phase}, 1);  // a radian
  add({s.disturbance, s.disturbance_frequency, s.start_velocity, s.omega, s.profile[0].omega,
       s.profile[1].omega, s.stiffness, s.contact_speed.value(), y.pull});
  add({y.wall_lower, y.wall_upper, y.start_position}, 3);
  add({y.restitution_lower, y.restitution_upper, y.start_velocity});
  add({s.pull_phase}, 3.5);
  add({s.disturbance_phase}, 1);
  return all;
}

/// Counts of scenes on record were judged with these very changes, and by limits that are kept.
TEST(Perturbation, DrawsItsChangesInAFixedOrder) {
  const auto given = drawn(full_scene());
  const auto kept = [](const Scene& s) {
    return std::tuple(s.counting_limit, s.peak_high, s.peak_low, s.contact_exponent,
                      std::get<Seconds>(s.window).count, s.profile[1].time);
  };
  for (const double stride : {golden, root_of_two}) {
    for (const double sign : {1.0, -1.0}) {
      const Scene near = perturbed(full_scene(), stride, sign);
      EXPECT_EQ(kept(near), kept(full_scene()));
      const auto changed = drawn(near);
      for (std::size_t i = 0; i < given.size(); ++i) {
        const double share = std::fmod(stride * static_cast<double>(i + 1), 1.0);
        const double weight = share < 0.5 ? share - 1 : share;  // of 0.5 to 1 either way
        EXPECT_NEAR((changed[i].first - given[i].first) / given[i].second,
                    sign * weight * perturbation_size, 1e-6 * perturbation_size)
            << i;
      }
    }
  }
}

TEST(Perturbation, KeepsZerosElasticWallsAndABodyOnAWall) {
  const Scene zeros = with(Scene{}, set::wall_lower(-1), set::start_position(-1));
  for (const double sign : {1.0, -1.0}) {
    const Scene near = perturbed(zeros, golden, sign);
    EXPECT_NE(near.mass, zeros.mass);
    EXPECT_THAT(
        (std::vector{near.friction, near.normal_force, near.pull, near.centrifugal_mass_radius,
                     near.slider_mass_radius, near.disturbance, near.start_velocity}),
        Each(0.0));
    EXPECT_LE(near.restitution_lower, 1);
    EXPECT_LE(near.restitution_upper, 1);
    EXPECT_NE(near.wall_lower, zeros.wall_lower);
    EXPECT_EQ(near.start_position, near.wall_lower);
    EXPECT_EQ(perturbed(with(zeros, set::wall_upper(infinity)), golden, sign).wall_upper, infinity);
  }
}

TEST(Perturbation, OfAValidSceneIsValid) {
  RandomScenes scenes(17);
  for (int i = 0; i < 500; ++i) {
    for (const Scene& scene : {scenes.next(), scenes.next_planar()}) {
      EXPECT_NO_THROW(check(perturbed(scene, golden, 1.0), "scene"));
      EXPECT_NO_THROW(check(perturbed(scene, root_of_two, -1.0), "scene"));
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
