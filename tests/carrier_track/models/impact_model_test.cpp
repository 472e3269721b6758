#include "problems/carrier_track/motion/impact_model.h"

#include <ceres/jet.h>

#include <Eigen/Dense>

#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

using std::numbers::pi;

TEST(ImpactModel, BouncingBallStrikesAndComesToRestAtTheClosedFormTimes) {
  for (const double friction : {0.0, 1.0}) {
    for (const double e : {0.0, 0.1, 0.5, 0.8, 0.97}) {
      const auto watched = watch(with(falling_ball(50, 9.8, e), set::friction(0.2),
                                      set::normal_force(5 * friction), set::seconds(1000)));
      const auto bounces = bounces_of(50, 9.8, e, 5000, friction);
      const auto& hits = watched.hits;
      ASSERT_LT(hits.size(), bounces.size());
      for (std::size_t k = 0; k < hits.size(); ++k) {
        expect_close(hits[k].time, bounces[k].time);
        expect_close(hits[k].speed, bounces[k].speed);
        EXPECT_EQ(hits[k].wall, Wall::lower);
        EXPECT_EQ(hits[k].speed * e > resting_speed, k + 1 < hits.size())
            << "listed until it rests";
      }
      // The last stretch is the rest until the end of the window.
      const auto& rest = watched.stretches.back();
      expect_close(rest.time, bounces.back().time);
      EXPECT_EQ(rest.flight.harmonics, 0);
      EXPECT_THAT(watched.end, FieldsAre(1000, 0, 0, testing::_));
      if (e != 0.8 || friction > 0) continue;
      // By another program, fifteen digits.
      EXPECT_NEAR(hits[0].time, 3.1943828249997, 1e-13);
      EXPECT_NEAR(hits[1].time, 8.30539534499922, 1e-13);
      EXPECT_NEAR(hits[2].time, 12.3942053609988, 1e-12);
      EXPECT_NEAR(rest.time, 28.7494454249973, 1e-12);
    }
  }
}

TEST(ImpactModel, BouncingBallIsFollowedAsFarAsItsImpactsCount) {
  const auto bounces = bounces_of(50, 9.8, 0.8, 200);
  for (const double slowest : {1e-3, 1e-9, 3e-12, 1e-15}) {
    const auto hits =
        watch(with(falling_ball(50, 9.8, 0.8), set::seconds(40), set::counting_limit(slowest)))
            .hits;
    const auto counts = [&](const auto& hit) { return hit.speed > slowest; };
    EXPECT_EQ(std::ranges::count_if(hits, counts), std::ranges::count_if(bounces, counts))
        << slowest;
    // What is left out is too slow for any surrogate.
    EXPECT_LE(hits.back().speed * 0.8, 1e-3 * slowest);
  }
}

TEST(ImpactModel, AnElasticBallKeepsItsEnergyOverAHundredThousandImpacts) {
  const double g = 4.9;
  const double down = std::sqrt(9.0 + 2 * g * 0.25);
  const double up = std::sqrt(down * down - 2 * g * 0.5);
  const double period = 2 * (down - up) / g;
  const auto hits = watch(with(Scene{}, set::pull(9.8), set::mass(2.0), set::wall_upper(0.5),
                               set::start(0.25, 3.0), set::seconds(60'000 * period)))
                        .hits;
  ASSERT_NEAR(static_cast<double>(hits.size()), 120'000.0, 1.0);
  for (std::size_t k = 0; k < hits.size(); ++k) {
    expect_close(hits[k].speed, k % 2 == 0 ? up : down, 1e-11);
    expect_close(hits[k].time, (3.0 - up) / g + 0.5 * period * static_cast<double>(k), 1e-11);
  }
}

TEST(ImpactModel, AGrazingImpactHasTheSpeedOfItsOverlap) {
  // Thrown up at 4 m/s against 8 m/s^2, the apex is at exactly 1 m.
  const auto hits_under = [](double wall) {
    return watch(with(Scene{}, set::start(0, 4), set::pull(8), set::restitution_lower(0),
                      set::seconds(2), set::wall_upper(wall)))
        .hits;
  };
  for (const double overlap : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const double wall = 1.0 - overlap;
    const auto touching = hits_under(wall);
    ASSERT_EQ(touching.size(), 2U) << overlap;
    EXPECT_EQ(touching[0].wall, Wall::upper);
    // v = sqrt(2 a d) for the gap as it was rounded.
    expect_close(touching[0].speed, std::sqrt(16.0 * (1.0 - wall)), 1e-7);
    const auto missing = hits_under(1.0 + overlap);
    ASSERT_EQ(missing.size(), 1U) << overlap;
    expect_close(missing[0].speed, 4.0);
  }
  const auto just = hits_under(1.0);
  for (const auto& hit : just) {
    if (hit.wall == Wall::upper) {
      EXPECT_LT(hit.speed, 1e-7);
    }
  }
  expect_close(just.back().speed, 4.0);
}

TEST(ImpactModel, RefusesAWindowWithTooManyImpacts) {
  Observer nobody;
  ImpactModel<double> model(with(Scene{}, set::start_velocity(1e3), set::seconds(1.0001e4)));
  EXPECT_THROW(model.run(nobody), std::runtime_error);
}

TEST(ImpactModel, EndsWhereTheForcesBalanceFrictionButForRounding) {
  // 0.1 + 0.2 exceeds 0.3 in binary, and other decimal sums fall short.
  for (int i = 1; i < 30; ++i) {
    for (int k = 1; k < 30; ++k) {
      for (const double mass : {1.0, 1.2, 3.0}) {
        const auto watched = watch(with(
            Scene{}, set::mass(mass), set::omega(0), set::pull(-0.1 * i), set::disturbance(0.1 * k),
            set::disturbance_frequency(0), set::friction(0.1), set::normal_force(i + k)));
        EXPECT_EQ(watched.end.time, 1.0);
        EXPECT_NEAR(watched.end.position, 0.5, 1e-14);
      }
    }
  }
}

TEST(ImpactModel, FliesOffWhereTheForceTurnsBeforeTheLastHopsWouldEnd) {
  // Strikes so slowly that it would rest, on a wall to which x'' = sin t - 1e-10 hardly presses it.
  const Scene scene =
      with(Scene{}, set::wall_upper(infinity), set::start(0, -1e-9), set::restitution_lower(0.5),
           set::pull(1e-10), set::centrifugal_mass_radius(1.0), set::phase(-pi / 2));
  expect_close(watch(scene).end.position, 1 - std::sin(1.0) + 0.5e-9 - 0.5e-10);
}

TEST(ImpactModel, SpendsNoEffortOnForcesThatCancelButForRounding) {
  Scene scene = with(Scene{}, set::pull(-0.3), set::pull_rotates(true), set::normal_force(1.0));
  for (const bool opposed : {false, true}) {
    scene.disturbance = opposed ? 0.3 : -0.3;
    scene.phase = opposed ? pi : 0.0;
    for (const double omega : {1.0, 0.3, 7.7, 10.0}) {
      scene.omega = scene.disturbance_frequency = omega;
      for (const double friction : {0.0, 0.4}) {
        scene.friction = friction;
        const auto watched = watch(scene);
        EXPECT_NEAR(watched.end.position, 0.5, 1e-14);
        EXPECT_LT(watched.end.evaluations, 1000);
      }
    }
  }
  // Here the rounding of larger forces leaves the plate's amplitude 7e-16 m/s^2 too great.
  scene.centrifugal_mass_radius = scene.slider_mass_radius = 0.3;
  scene.friction = 0.0;
  EXPECT_LT(watch(scene).end.evaluations, 1000);
}

/// Far from any wall, friction 0.25 x 2 N on 0.8 kg.
Scene block_on_track() {
  return with(Scene{}, set::walls(-100, infinity), set::start(0, 0), set::mass(0.8),
              set::friction(0.25), set::normal_force(2.0));
}
constexpr double track_friction = 0.25 * 2.0 / 0.8;  // [m/s^2]

/// The block under a force friction / share sin(omega t), which exceeds friction from the angle
/// asin(share) on.
Scene shaken_block(double share) {
  return with(block_on_track(), set::omega(3.0), set::phase(-pi / 2),
              set::centrifugal_mass_radius(track_friction * 0.8 / share / 9.0));
}

TEST(Friction, YieldsToTheSmallestExcessOfForce) {
  const double excess = 0x1p-40;  // exact beside the 0.5 N of friction
  for (const double sign : {-1.0, 1.0}) {
    const Scene scene = with(block_on_track(), set::mass(1.0), set::pull(-sign * (0.5 + excess)),
                             set::seconds(1000));
    expect_close(watch(scene).end.position, sign * 0.5 * excess * 1e6);
  }
}

TEST(Friction, LetsABodySlipWhenAGrowingForceLeavesItsBand) {
  for (const double share : {0.1, 0.5, 0.9, 0.999, 1 - 1e-9}) {
    const double release = std::asin(share) / 3.0;
    const double end = release + 0.1 * (pi / 2 - std::asin(share)) / 3.0;
    const auto watched = watch(with(shaken_block(share), set::seconds(end)));
    ASSERT_EQ(watched.stretches.size(), 2U) << share;
    // The force meets the edge of the band ever more flatly: its time is worth fewer digits.
    expect_close(watched.stretches[1].time, release, 1e-12 + 1e-15 / (1 - share * share));
    const double a = track_friction / share;
    const double velocity = a / 3.0 * (std::cos(3.0 * release) - std::cos(3.0 * end)) -
                            track_friction * (end - release);
    EXPECT_NEAR(watched.end.velocity, velocity, 1e-15);
  }
  // And from one that stays within it by a billionth.
  const auto held = watch(with(shaken_block(1 + 1e-9), set::seconds(20)));
  EXPECT_EQ(held.end.position, 0.0);
  EXPECT_EQ(held.stretches.size(), 1U);
}

// Orbits with closed forms, for a body seen from walls that shake as A sin(omega t): in their
// frame x'' = ... + A omega^2 sin(omega t), and the walls stand still.

constexpr double shaking = 30.0;

/// Walls shaken with amplitude [m] that stand at `angle` when the body starts.
Scene shaken(double amplitude, double angle, double restitution) {
  return with(Scene{}, set::mass(2), set::omega(shaking),
              set::centrifugal_mass_radius(2 * amplitude), set::phase(angle - pi / 2),
              set::restitution(restitution), set::start_position(0));
}

/// Jacobian of (angle, speed of departure) at the next impact with respect to the same now, by
/// duals. The sign of the start velocity is that of the departure.
Eigen::Matrix2d return_map(const Scene& scene) {
  using Jet = ceres::Jet<double, 2>;
  auto dual = lifted<Jet>(scene);
  dual.phase.v[0] = 1.0;
  dual.start_velocity.v[1] = scene.start_velocity > 0 ? 1.0 : -1.0;
  const auto hit = watch(dual).hits.at(0);
  const Jet angle = dual.phase + dual.omega * hit.time;
  const Jet speed = dual.restitution_lower * hit.speed;
  Eigen::Matrix2d map;
  map << angle.v.transpose(), speed.v.transpose();
  return map;
}

double spectral_radius(const Scene& scene) {
  return return_map(scene).eigenvalues().cwiseAbs().maxCoeff();
}

constexpr double gravity = 9.81;

/// A ball on a table of peak acceleration `strength` gravity, on the orbit that strikes every
/// n-th period.
Scene on_table(double strength, double e, int n) {
  const double cosine = n * pi * (1 - e) / ((1 + e) * strength);
  return with(shaken(strength * gravity / (shaking * shaking), std::acos(cosine), e),
              set::wall_upper(infinity), set::pull(2 * gravity),
              set::start_velocity(e / (1 + e) * gravity * 2 * pi * n / shaking),
              set::seconds(1.5 * 2 * pi * n / shaking));
}

double doubling_strength(double e, int n) {
  return std::hypot(n * pi * (1 - e) / (1 + e), 2 * (1 + e * e) / ((1 + e) * (1 + e)));
}

TEST(PeriodicOrbit, ABallOnATableStrikesOnceUpToTheClosedFormStrengthAndThenDoublesItsPeriod) {
  // By another program, in extended precision.
  EXPECT_NEAR(doubling_strength(0.5, 1), 1.526823700519, 5e-13);
  for (const double e : {0.2, 0.5, 0.8}) {
    for (const int n : {1, 2, 3}) {
      const double strength = doubling_strength(e, n);
      const auto hit = watch(on_table(strength * 0.99, e, n)).hits.at(0);
      expect_close(hit.time, 2 * pi * n / shaking);
      expect_close(hit.speed, gravity * 2 * pi * n / shaking / (1 + e));
      // At the boundary an eigenvalue is -1: 1 + trace + determinant = 0.
      const Eigen::Matrix2d map = return_map(on_table(strength, e, n));
      EXPECT_NEAR(1 + map.trace() + map.determinant(), 0.0, 1e-11);
      EXPECT_NEAR(map.determinant(), e * e, 1e-11);
      EXPECT_LT(spectral_radius(on_table(strength * 0.999, e, n)), 1.0);
      EXPECT_GT(spectral_radius(on_table(strength * 1.001, e, n)), 1.0);
    }
  }
}

/// A free body between two shaken walls, a gap of `ratio` amplitudes apart, leaving the upper wall
/// on the symmetric orbit of the greater speed.
Scene between_walls(double ratio, double e) {
  const double amplitude = 0.01;
  const double gap = ratio * amplitude;
  const double rho = (1 - e) / (1 + e);
  // (u pi/w - d)^2 / 4 + (rho u/w)^2 = A^2 as a quadratic in u/w.
  const double a = pi * pi / 4 + rho * rho;
  const double b = pi * gap / 4;
  const double c = gap * gap / 4 - amplitude * amplitude;
  const double u = shaking * (b + std::sqrt(std::max(0.0, b * b - a * c))) / a;
  const double angle = std::atan2((u * pi / shaking - gap) / 2, -rho * u / shaking);
  return with(shaken(amplitude, angle, e), set::wall_upper(gap),
              set::start(gap, -e * u * (1 + rho)), set::revolutions(0.75));
}

double lowest_ratio(double rho) {
  return (pi * pi - 4) / std::sqrt(4 + pi * pi * rho * rho);
}

double highest_ratio(double rho) {
  return std::sqrt(pi * pi + 4 * rho * rho) / rho;
}

TEST(PeriodicOrbit, ABodyBetweenShakenWallsStrikesOncePerHalfPeriodStablyBetweenClosedFormBounds) {
  // By another program, in extended precision.
  EXPECT_NEAR(lowest_ratio(1.0 / 3), 2.5999655236, 5e-11);
  EXPECT_NEAR(highest_ratio(1.0 / 3), 9.6346478716, 5e-11);
  for (const double e : {0.3, 0.5, 0.8, 0.9}) {
    const double rho = (1 - e) / (1 + e);
    const double low = lowest_ratio(rho);
    const double high = highest_ratio(rho);
    // Half a period and a mirror make the map; its eigenvalues leave the unit circle at -1 and +1.
    const Eigen::Matrix2d lowest = return_map(between_walls(low, e));
    EXPECT_NEAR(1 + lowest.trace() + lowest.determinant(), 0.0, 1e-10);
    const Eigen::Matrix2d highest = return_map(between_walls(high, e));
    EXPECT_NEAR(1 - highest.trace() + highest.determinant(), 0.0, 1e-6);
    EXPECT_GT(spectral_radius(between_walls(low * 0.999, e)), 1.0);
    for (const double ratio : {low * 1.001, 3.0, 4.0, 6.0, (low + high) / 2, high * 0.999}) {
      const Scene scene = between_walls(ratio, e);
      EXPECT_LT(spectral_radius(scene), 1.0) << ratio;
      const auto hit = watch(scene).hits.at(0);
      EXPECT_EQ(hit.wall, Wall::lower);
      expect_close(hit.time, pi / shaking);
      expect_close(hit.speed, -scene.start_velocity / e);
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
