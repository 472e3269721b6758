#include "problems/carrier_track/check/oracle.h"

#include "problems/carrier_track/check/first_fall.h"
#include "problems/carrier_track/check/push.h"
#include "problems/carrier_track/check/random_scenes.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

using std::numbers::pi;

/// Expects numbers with more digits than a double to be near each other.
void expect_digits(long double actual, long double expected, long double tolerance) {
  EXPECT_NEAR(static_cast<double>(actual - expected), 0, static_cast<double>(tolerance));
}

/// Expects their quotient to be 1.
void expect_ratio(long double actual, long double expected, double tolerance) {
  EXPECT_NEAR(static_cast<double>(actual / expected), 1, tolerance);
}

constexpr double rounding = 4e-16;  // of a double, and of the few operations of a closed form

TEST(Oracle, BouncesABallAtTheTimesOfItsClosedForm) {
  for (const double friction : {0.0, 1.0}) {
    const Scene scene = with(falling_ball(50, 9.8, 0.8), set::friction(0.2),
                             set::normal_force(5 * friction), set::seconds(40));
    const OracleRun run = oracle_run(scene);
    ASSERT_TRUE(run.finished);
    ASSERT_GT(run.impacts.size(), 40U);
    const auto bounces = bounces_of(50, 9.8, 0.8, run.impacts.size(), friction);
    for (std::size_t k = 0; k < bounces.size(); ++k) {
      expect_ratio(run.impacts[k].time, bounces[k].time, rounding);
      expect_ratio(run.impacts[k].speed, bounces[k].speed, rounding);
    }
    EXPECT_EQ(run.count, std::ranges::count_if(bounces, [&](const Bounce& bounce) {
                return bounce.speed > scene.counting_limit;
              }));
  }
}

TEST(Oracle, CountsTheMaximaOfABouncingBallOrSaysThatTheyNeverEnd) {
  // Thrown up to 5 m, and a quarter as high each time, within 4 s.
  Scene scene = with(falling_ball(0, 10, 0.5), set::rule(CountRule::peaks), set::start_velocity(10),
                     set::peak_high(0.01), set::peak_low(1e-300), set::seconds(3.99));
  const OracleRun counted = oracle_run(scene);
  EXPECT_EQ(counted.count, 5);  // 5, 1.25, 0.31, 0.078, 0.0195
  for (std::size_t k = 0; k < counted.maxima.size(); ++k) {
    const double height = 5 * std::pow(0.25, k);
    EXPECT_NEAR(counted.maxima[k].position / height, 1, rounding);
  }
  EXPECT_FALSE(counted.endless);
  scene.window = Seconds{5};
  EXPECT_TRUE(oracle_run(scene).endless);
  // Between the limits none counts.
  scene.wall_lower = scene.start_position = 0.001;
  EXPECT_FALSE(oracle_run(scene).endless);
  EXPECT_EQ(oracle_run(scene).count, 5);
}

TEST(Oracle, CountsAStayOnTheUpperWallOnce) {
  // Thrown to a ceiling without rebound, on which x'' = sin t holds it from 0 to pi.
  const Scene scene = with(Scene{}, set::rule(CountRule::peaks), set::centrifugal_mass_radius(1),
                           set::phase(-pi / 2), set::start_velocity(1), set::restitution_upper(0),
                           set::peak_high(0.9));
  EXPECT_EQ(oracle_run(with(scene, set::seconds(3.1))).count, 0) << "it is still there";
  const OracleRun run = oracle_run(with(scene, set::seconds(3.5)));
  EXPECT_EQ(run.count, 1);
  EXPECT_EQ(run.maxima.front().position, 1.0);
}

TEST(Oracle, ReleasesABodyWhenItsForceExceedsFriction) {
  // x'' = sin(t) - 0.3 from t0 = asin(0.3) on, in closed form at the time where it comes to rest.
  const OracleRun run = oracle_run(
      with(Scene{}, set::centrifugal_mass_radius(1), set::phase(-pi / 2), set::friction(0.3),
           set::normal_force(1), set::start_position(0), set::wall_upper(10), set::seconds(6)));
  ASSERT_EQ(run.summits.size(), 1U);
  const long double t0 = std::asin(static_cast<long double>(0.3));
  const long double t = run.summits[0].time;
  const long double friction = 0.3;
  expect_digits(std::cos(t0) - std::cos(t), friction * (t - t0), 2e-15);
  const long double height =
      std::cos(t0) * (t - t0) - (std::sin(t) - std::sin(t0)) - friction * (t - t0) * (t - t0) / 2;
  expect_digits(run.summits[0].height, height, rounding);
}

TEST(Oracle, NeverReleasesABodyHeldAtTheVeryLimit) {
  // What moves at all strikes.
  const Scene scene = with(Scene{}, set::disturbance(1), set::friction(1), set::normal_force(1),
                           set::start_position(0), set::wall_upper(1e-30), set::seconds(100));
  EXPECT_TRUE(oracle_run(scene).impacts.empty());
  EXPECT_FALSE(oracle_run(with(scene, set::normal_force(1 - 1e-12))).impacts.empty());
}

TEST(Oracle, DecidesAGrazingInTheLastDigitOfTheWall) {
  // Thrown up to exactly 1 m.
  const Scene scene = with(falling_ball(0, 0.5, 0.5), set::start_velocity(1), set::seconds(3));
  EXPECT_TRUE(oracle_run(with(scene, set::wall_upper(std::nextafter(1.0, 2.0)))).impacts.empty());
  const double below = std::nextafter(1.0, 0.0);
  const OracleRun run = oracle_run(with(scene, set::wall_upper(below)));
  ASSERT_EQ(run.impacts.size(), 1U);
  expect_ratio(run.impacts[0].speed, std::sqrt(1 - below), 1e-3);
}

TEST(Oracle, SaysWhereItBreaksOff) {
  // Elastic, to and fro.
  const OracleRun run = oracle_run(with(Scene{}, set::start_velocity(1), set::seconds(1e4)));
  EXPECT_FALSE(run.finished);
  EXPECT_EQ(run.impacts.size(), oracle_impact_cap);
}

Push push_of(const Scene& scene, long double until) {
  return Push(applied_force(scene), scene.mass, until);
}

TEST(Push, OfAWholeIsThatOfItsParts) {
  for_random(1, 1000, [](RandomScenes& draws) {
    const Push push = push_of(draws.next(), 10);
    const long double start = draws.within(0, 2);
    const long double reach = std::min(push.known_until(start) - start, 1.0L);
    const long double first = reach * draws.log_within(1e-9, 0.5);
    const long double second = reach * draws.log_within(1e-9, 0.5);
    const Pushed whole = PushFrom(push, start).after(first + second);
    const Pushed one = PushFrom(push, start).after(first);
    const Pushed two = PushFrom(push, start + first).after(second);
    const long double noise = 1e-16L * push.strength();
    const long double time = first + second;
    expect_digits(one.distance + one.speed * second + two.distance, whole.distance,
                  noise * time * time);
    expect_digits(one.speed + two.speed, whole.speed, noise * time);
    expect_digits(two.acceleration, whole.acceleration, noise);
  });
}

TEST(Push, KeepsTheDigitsOfTheShortestHop) {
  const Push push = push_of(with(Scene{}, set::centrifugal_mass_radius(1), set::phase(1)), 1);
  for (const long double t : {1e-6L, 1e-9L, 1e-12L}) {
    // cos(1 + t) integrated twice, to the order of what is left out.
    const long double expected =
        t * t * (std::cos(1.0L) / 2 - t * (std::sin(1.0L) / 6 + t * std::cos(1.0L) / 24));
    expect_digits(PushFrom(push, 0).after(t).distance / expected, 1, 1e-18);
  }
}

TEST(Push, StaysWithinItsBounds) {
  for_random(2, 1000, [](RandomScenes& draws) {
    Scene scene = draws.next();
    if (draws.chance(0.5)) scene.disturbance_frequency = scene.omega * (1 + 1e-6);
    const long double time = draws.within(0, 2);
    const Push push = push_of(scene, time);
    const Pushed now = PushFrom(push, time).after(0);
    ASSERT_LE(std::abs(now.acceleration), push.strength() * (1 + 1e-15L));
    ASSERT_LE(std::abs(now.jerk), push.bound(1) * (1 + 1e-15L));
    ASSERT_LE(std::abs(now.snap), push.bound(2) * (1 + 1e-15L));
  });
}

TEST(Push, OfTwoWavesThatAlmostCancelHasASmallBound) {
  const Push push =
      push_of(with(Scene{}, set::centrifugal_mass_radius(1), set::omega(2),
                   set::disturbance_frequency(2 * (1 + 1e-9)), set::disturbance(-4 * (1 + 1e-9))),
              1);
  EXPECT_NEAR(static_cast<double>(push.strength()), 8, 1e-7);
  EXPECT_LT(push.bound(1), 1e-7L);
  EXPECT_GT(push.bound(1), 1e-9L);
}

TEST(Push, MovesABodyAsItsIntegralSaysAndHasTheDerivativesOfItsAcceleration) {
  for (const PushTerm& term :
       {PushTerm{{1, 2, -3}, {0.3L, 5, 2}}, PushTerm{{0.5L, 0, 0}, {0, 0, 0}},
        PushTerm{{2, 0, 1}, {-1, 0, 40}}, PushTerm{{1, 1, 1}, {0, 0, 0}}}) {
    const Push push({{0, {term}}}, 1, 2);
    for (const long double start : {0.0L, 0.7L}) {
      const long double elapsed = std::min(push.known_until(start) - start, 0.5L);
      // Simpson's rule, in steps much finer than the force changes.
      constexpr int steps = 4000;
      const long double h = elapsed / steps;
      long double speed = 0;
      long double distance = 0;
      for (int k = 0; k <= steps; ++k) {
        const auto& [a, p] = term;
        const long double u = start + h * k;
        const int weight = k == 0 || k == steps ? 1 : k % 2 == 1 ? 4 : 2;
        const long double gain = (a[0] + u * (a[1] + u * a[2])) *
                                 std::cos(p[0] + u * (p[1] + u * p[2])) * h / 3 * weight;
        speed += gain;
        distance += gain * (elapsed - h * k);
      }
      const PushFrom from(push, start);
      expect_digits(from.after(elapsed).speed, speed, 1e-15);
      expect_digits(from.after(elapsed).distance, distance, 1e-15);
      const Pushed before = from.after(elapsed / 2 - h / 10), now = from.after(elapsed / 2),
                   after = from.after(elapsed / 2 + h / 10);
      expect_digits((after.acceleration - before.acceleration) / (h / 5), now.jerk, 1e-4);
      expect_digits((after.jerk - before.jerk) / (h / 5), now.snap, 1e-4);
    }
  }
}

TEST(Push, EndsAtTheNextPiece) {
  const Push push({{0, {}}, {0.5L, {{{1, 0, 0}, {0, 100, 0}}}}}, 1, 2);
  EXPECT_EQ(push.known_until(0.1L), 0.5L);
  EXPECT_EQ(push.smooth_until(0.1L), 0.5L);
  expect_digits(push.known_until(0.5L), 0.53L, 1e-12);  // 3 rad
  EXPECT_EQ(PushFrom(push, 0.1L).after(0.2L).acceleration, 0);
  EXPECT_EQ(PushFrom(push, 0.5L).after(0).acceleration, 1);
}

/// level + cos(t), whose first fall below zero is at acos(-level).
struct Raised {
  long double level;
  Jet operator()(long double t) const { return {level + std::cos(t), -std::sin(t), -std::cos(t)}; }
};

Search search(const Raised& f, long double horizon, long double guess,
              long double passed_at = infinity) {
  const auto noise = [](long double) { return 1e-18L; };
  const auto passed = [&](long double t) { return t >= passed_at; };
  return first_fall(f, {1, 1e-18L}, noise, passed, horizon, guess);
}

TEST(FirstFall, IsolatesARootWhateverTheFirstPiece) {
  for_random(1, 1000, [](RandomScenes& draws) {
    const Raised f{draws.within(-0.99, 0.99)};
    const long double expected = std::acos(-f.level);
    const Search found = search(f, draws.within(4, 1000), draws.log_within(1e-9, 1e3));
    ASSERT_EQ(found.end, Search::End::falls);
    ASSERT_LE(found.lower, expected);
    ASSERT_GE(found.upper, expected);
    expect_digits(root_between(f, found.lower, found.upper), expected, 1e-17);
  });
}

TEST(FirstFall, FindsADipOfTheSixteenthDigitAndTakesATouchForNone) {
  for (const long double depth : {1e-6L, 1e-12L, 1e-16L}) {
    const Raised f{1 - depth};
    const Search found = search(f, 1000, 1);
    ASSERT_EQ(found.end, Search::End::falls) << static_cast<double>(depth);
    // The dip is only 2 sqrt(2 depth) wide.
    const long double root = root_between(f, found.lower, found.upper);
    expect_ratio(std::acos(-1.0L) - root, std::sqrt(2 * depth), 0.1);
  }
  for (const long double level : {1.0L, 1 + 1e-16L}) {
    EXPECT_EQ(search({level}, 1000, 1).end, Search::End::never);
  }
}

TEST(FirstFall, EndsWhereTheCallersEventPasses) {
  const Search found = search({0}, 10, 0.1L, 1);
  EXPECT_EQ(found.end, Search::End::passes);
  EXPECT_LE(found.lower, 1);
  EXPECT_GE(found.upper, 1);
}

}  // namespace
}  // namespace ricochet::carrier_track
