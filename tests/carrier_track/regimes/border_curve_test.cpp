#include "problems/carrier_track/regimes/border_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "problems/carrier_track/problems/default_machine.h"
#include "problems/carrier_track/regimes/orbit_map.h"
#include "ricochet/error.h"

namespace ricochet::carrier_track {
namespace {

/// The border of a machine like the default one beyond which a turn has more than two collisions.
Border<SteadyMotion> louder_than_two(const Scene& machine) {
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
}

TEST(BorderCurve, RefusesOtherBordersAndConstants) {
  const SteadyMotion still = steady_motion(at_speed(default_machine(), 1.0));
  EXPECT_THROW(BorderCurve(first_border(still, followed(still, 2.0)), "friction"),
               std::invalid_argument);
  EXPECT_THROW(BorderCurve(louder_than_two(default_machine()), "wall_lower"), InputError);
}

}  // namespace
}  // namespace ricochet::carrier_track
