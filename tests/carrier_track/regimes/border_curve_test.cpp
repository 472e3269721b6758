#include "problems/carrier_track/regimes/border_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/regimes/random_machine.h"
#include "tests/carrier_track/regimes/shaken_table.h"

namespace ricochet::carrier_track {
namespace {

/// The border of a machine like the default one beyond which a turn has more than two collisions.
Border louder_than_two(const Scene& machine) {
  const SteadyMotion slow = steady_motion(at_speed(machine, 4.0));
  return first_border(slow, followed(slow, 16.0));
}

Scene with(const std::string& key, double factor) {
  Scene machine = default_machine();
  machine.pull = 0.02;
  set_constant(machine, key, factor * constant_named(machine, key));
  return machine;
}

TEST(BorderCurve, HasTheSlopesOfBordersSolvedAnew) {
  for (const std::string key : {"mass", "clearance", "restitution", "friction", "normal_force",
                                "centrifugal_mass_radius", "counting_limit", "pull"}) {
    const BorderCurve curve(louder_than_two(with(key, 1)), key);
    const double constant = constant_named(with(key, 1), key);
    EXPECT_DOUBLE_EQ(curve.here().constant, constant);
    const double change =
        louder_than_two(with(key, 1 + 1e-5)).omega - louder_than_two(with(key, 1 - 1e-5)).omega;
    EXPECT_NEAR(curve.here().slope * constant, change / 2e-5,
                1e-6 * std::abs(curve.here().slope * constant) + 1e-7)
        << key;
  }
}

TEST(BorderCurve, ArrivesAtTheBordersOfOtherMachines) {
  for (const std::string key : {"restitution", "friction", "counting_limit", "clearance"}) {
    for (const double factor : {0.8, 1.25}) {
      BorderCurve curve(louder_than_two(with(key, 1)), key);
      ASSERT_TRUE(curve.follow_to(factor * curve.here().constant)) << key;
      EXPECT_NEAR(curve.here().omega / louder_than_two(with(key, factor)).omega, 1, 1e-10) << key;
    }
  }
}

TEST(BorderCurve, EndsWhereTheBorderEnds) {
  BorderCurve curve(louder_than_two(default_machine()), "counting_limit");
  EXPECT_FALSE(curve.follow_to(-1));
  EXPECT_GT(curve.here().constant, 0);
  EXPECT_NE(curve.end(), CurveEnd::range);
}

TEST(BorderCurve, FollowsTheReleaseByItsClosedForm) {
  Scene machine = default_machine();
  machine.pull = 0;
  machine.slider_mass_radius = 0;
  const SteadyMotion still = steady_motion(at_speed(machine, 1.0));
  BorderCurve curve(first_border(still, followed(still, 2.0)), "friction");
  const double force = machine.normal_force / machine.centrifugal_mass_radius;
  for (const double friction : {0.05, 0.4}) {
    ASSERT_TRUE(curve.follow_to(friction));
    EXPECT_NEAR(curve.here().omega / std::sqrt(friction * force), 1, 1e-12);
    EXPECT_NEAR(curve.here().slope / (0.5 * std::sqrt(force / friction)), 1, 1e-12);
  }
}

/// The shaken table's orbit at the speed from which its period doubles.
Border flip_of(double e) {
  using namespace shaken_table;
  const double flip = flip_strength(e);
  const SteadyMotion orbit = steady_motion(on_orbit(e, 0.98 * flip));
  return first_border(orbit, followed(orbit, speed_at(1.02 * flip)));
}

TEST(BorderCurve, FollowsAFlipByItsClosedForm) {
  using namespace shaken_table;
  const auto flip_at = [](double e) { return speed_at(flip_strength(e)); };
  BorderCurve curve(flip_of(0.5), "restitution");
  for (const double e : {0.5, 0.55, 0.45}) {
    ASSERT_TRUE(curve.follow_to(e));
    EXPECT_NEAR(curve.here().omega / flip_at(e), 1, 1e-9);
    EXPECT_NEAR(curve.here().slope / ((flip_at(e + 1e-6) - flip_at(e - 1e-6)) / 2e-6), 1, 1e-5);
  }
}

TEST(BorderCurve, FollowsAFoldDownwardsByItsClosedForm) {
  using namespace shaken_table;
  const auto fold_at = [](double e) { return speed_at(fold_strength(e)); };
  const SteadyMotion orbit = steady_motion(on_orbit(0.5, 1.05 * fold_strength(0.5)));
  BorderCurve curve(first_border(orbit, followed(orbit, speed_at(0.98 * fold_strength(0.5)))),
                    "restitution");
  for (const double e : {0.5, 0.55}) {
    ASSERT_TRUE(curve.follow_to(e)) << static_cast<int>(curve.end());
    EXPECT_NEAR(curve.here().omega / fold_at(e), 1, 1e-7);
  }
}

TEST(BorderCurve, SaysThatItTurnsBack) {
  const Scene machine = random_machine(10);
  const std::vector<Regime> regimes = regimes_of(machine, {0.01, 6});
  BorderCurve curve(border_between(regimes.at(3), regimes.at(4)), "counting_limit");
  ASSERT_FALSE(curve.follow_to(0.3 * curve.here().constant));
  EXPECT_EQ(curve.end(), CurveEnd::fold_back);
  // The speed of the impact has its least value there: no machine with a lower limit has the
  // border.
  const BorderPoint end = curve.here();
  const auto passes = [&](double limit) {
    Scene other = machine;
    other.counting_limit = limit;
    std::set<double> counts;
    for (double factor = 0.99; factor < 1.01; factor += 5e-4) {
      counts.insert(steady_motion(at_speed(other, factor * end.omega)).collisions);
    }
    return counts.size() > 1;
  };
  EXPECT_TRUE(passes(end.constant * (1 + 1e-4)));
  EXPECT_FALSE(passes(end.constant * (1 - 1e-4)));
}

TEST(BorderCurve, BeginsBetweenTwoRegimes) {
  const std::vector<Regime> regimes = regimes_of(default_machine());
  ASSERT_GT(regimes.size(), 3U);
  for (std::size_t i = 0; i + 1 < regimes.size(); ++i) {
    const BorderCurve curve(border_between(regimes[i], regimes[i + 1]), "friction");
    EXPECT_NEAR(curve.here().omega / regimes[i].to, 1, 1e-11);
  }
}

TEST(BorderCurve, RefusesEqualMotionsAndUnknownConstants) {
  const SteadyMotion still = steady_motion(at_speed(default_machine(), 1.0));
  EXPECT_THROW(BorderCurve({1.0, RegimeEnd::release, still, still}, "friction"),
               std::invalid_argument);
  EXPECT_THROW(BorderCurve(louder_than_two(default_machine()), "wall_lower"), InputError);
}

}  // namespace
}  // namespace ricochet::carrier_track
