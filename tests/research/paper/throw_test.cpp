#include "src/research/paper/throw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "problems/carrier_track/problems/default_machine.h"
#include "problems/carrier_track/regimes/border_curve.h"
#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "problems/carrier_track/regimes/orbit_map.h"
#include "ricochet/random.h"
#include "ricochet/regimes.h"
#include "src/research/paper/fitted_interpretation.h"

namespace ricochet::carrier_track {
namespace {

Scene machine_of(const std::string& id) {
  return scene_of(find_case(id), default_interpretation().scene);
}

TEST(Throw, HasTheBordersOfTheLongRun) {
  for (const char* id : {"C1", "C2", "C3", "C4"}) {
    for (const int at_most : {0, 2, 4, 6}) {
      const Scene machine = machine_of(id);
      const double border = quiet_up_to(machine, at_most).value();
      const auto law = throw_border(machine, at_most);
      if (border == 18) {
        EXPECT_GT(law.value_or(1000), 18) << id << ' ' << at_most;
      } else {
        ASSERT_TRUE(law) << id << ' ' << at_most;
        // Just above silence a throw may end in the gap, and the next one begins there.
        EXPECT_NEAR(*law / border, 1, at_most == 0 ? 1e-3 : 1e-9) << id << ' ' << at_most;
      }
    }
  }
}

TEST(Throw, HasTheBordersOfMachinesDrawnAtRandom) {
  Random random(7);
  int compared = 0;
  for (int k = 0; k < 60; ++k) {
    Scene machine = machine_of("C1");
    const auto times = [&](double factor) { return std::pow(factor, 2 * uniform(random) - 1); };
    machine.contact_friction = k % 2 == 0;
    machine.restitution_lower = machine.restitution_upper = 0.05 + 0.9 * uniform(random);
    machine.friction = 0.05 + 0.45 * uniform(random);
    machine.pull = 3 * machine.friction * uniform(random);
    machine.mass *= times(2);
    machine.wall_upper *= times(5);
    machine.start_position = 0;
    machine.counting_limit *= times(2);
    machine.normal_force *= times(3);
    const auto border = quiet_up_to(machine, 2);
    const auto law = throw_border(machine, 2);
    if (!border || *border == 18) continue;
    const SteadyMotion before = steady_motion(at_speed(machine, 0.98 * *border));
    // Else a throw ends in the gap, and the next one begins there.
    const auto strikes = [&](Wall wall) {
      return std::ranges::any_of(before.impacts, [&](const Impact& i) { return i.wall == wall; });
    };
    if (!strikes(Wall::lower) || !strikes(Wall::upper)) continue;
    ++compared;
    ASSERT_TRUE(law) << k;
    EXPECT_NEAR(*law / *border, 1, 1e-9) << k;
  }
  EXPECT_GT(compared, 30);
}

TEST(Throw, HasTheSlopesOfTheBorderCurve) {
  const Scene machine = machine_of("C1");
  const SteadyMotion slow = steady_motion(at_speed(machine, 4.0));
  for (const std::string key : {"restitution", "friction", "clearance", "counting_limit"}) {
    const BorderCurve curve(first_border(slow, followed(slow, 16.0)), key);
    const auto border_at = [&](double factor) {
      Scene changed = machine;
      set_constant(changed, key, factor * constant_named(machine, key));
      return throw_border(changed, 2).value();
    };
    const double slope = (border_at(1 + 1e-5) - border_at(1 - 1e-5)) / 2e-5;
    EXPECT_NEAR(slope, curve.here().slope * constant_named(machine, key), 1e-4) << key;
  }
}

TEST(Throw, IsTheImpactsOfATurnAtRest) {
  const Scene machine = at_speed(machine_of("C2"), 1.9);
  const SteadyMotion motion = steady_motion(machine);
  for (const Wall wall : {Wall::lower, Wall::upper}) {
    std::vector<double> speeds;
    for (const Impact& impact : motion.impacts) {
      if (impact.wall == wall) speeds.push_back(impact.speed);
    }
    std::sort(speeds.begin(), speeds.end(), std::greater<>());
    const std::vector<double> law = throw_speeds(machine, wall, 5);
    ASSERT_EQ(law.size(), 5U);
    for (std::size_t k = 0; k < law.size(); ++k) EXPECT_NEAR(law[k] / speeds[k], 1, 1e-9) << k;
  }
  EXPECT_TRUE(throw_speeds(at_speed(machine, 1.0), Wall::lower, 1).empty()) << "friction holds it";
}

TEST(Throw, TakesADisturbanceAsASteadyForce) {
  for (const char* id : {"C5", "C7", "C9"}) {
    const Scene machine = machine_of(id);
    const double some = throw_border(machine, 2).value();
    const double all = throw_border(machine, 2, Louder::all).value();
    EXPECT_GT(disturbed_motion(at_speed(machine, some * 1.001)).most, 2) << id;
    EXPECT_EQ(disturbed_motion(at_speed(machine, some * 0.999)).most, 2) << id;
    EXPECT_GT(disturbed_motion(at_speed(machine, all * 1.001)).least, 2) << id;
    EXPECT_EQ(disturbed_motion(at_speed(machine, all * 0.999)).least, 2) << id;
  }
}

TEST(Throw, HasNoBorderWhereNoImpactIsFastEnough) {
  Scene machine = machine_of("C1");
  machine.counting_limit = 10;
  EXPECT_FALSE(throw_border(machine, 2, Louder::some, 18));
}

}  // namespace
}  // namespace ricochet::carrier_track
