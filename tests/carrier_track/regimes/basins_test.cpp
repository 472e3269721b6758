#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "ricochet/random.h"
#include "tests/carrier_track/regimes/shaken_table.h"

namespace ricochet::carrier_track {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double height = 0.03;  // m
constexpr double fastest = 1.0;  // m/s
constexpr double restitution = 0.8;

/// A ball above a table that moves as A cos(omega t): an own simulation in the room's frame, with
/// small steps. Returns whether it still bounces after many periods; below one gravity a ball that
/// has come to rest stays.
bool bounces(double omega, double phase, double above, double relative_velocity) {
  using namespace shaken_table;
  const auto table = [&](double t) { return amplitude * std::cos(omega * t + phase); };
  const auto table_velocity = [&](double t) {
    return -amplitude * omega * std::sin(omega * t + phase);
  };
  const double period = 2 * std::numbers::pi / omega;
  double from = 0, y = table(0) + above, v = table_velocity(0) + relative_velocity;
  while (from < 150 * period) {
    const auto gap = [&](double t) {
      const double flown = t - from;
      return y + v * flown - gravity * flown * flown / 2 - table(t);
    };
    // The flight of least interest lasts some millionth of a period.
    double step = 1e-6 * period, t = from + step;
    while (gap(t) > 0) {
      step = std::min(1.3 * step, period / 400);
      t += step;
    }
    double low = t - step, high = t;
    for (int i = 0; i < 60; ++i) (gap((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
    const double impact = table_velocity(high) - (v - gravity * (high - from));
    if (impact < 1e-4) return false;
    from = high;
    y = table(high);
    v = table_velocity(high) + restitution * impact;
  }
  return true;
}

/// The share of bouncing balls among random starts.
double bouncing_share(double omega, int starts) {
  Random random(99);
  int bouncing = 0;
  for (int i = 0; i < starts; ++i) {
    const double phase = 2 * std::numbers::pi * uniform(random);
    const double above = height * uniform(random);
    if (bounces(omega, phase, above, fastest * (2 * uniform(random) - 1))) ++bouncing;
  }
  return static_cast<double>(bouncing) / starts;
}

TEST(Basins, StickingAndBouncingBallsDivideAsInASimulationOfTheirOwn) {
  const double strength = 0.6;  // between the folds of one and of two turns, and below lift-off
  ASSERT_GT(strength, shaken_table::fold_strength(restitution));
  ASSERT_LT(strength, 2 * shaken_table::fold_strength(restitution));
  const Scene table = shaken_table::on_orbit(restitution, strength);
  const int starts = 1500;
  const Basins found = basins_of(table, {starts, 7, height, fastest});
  ASSERT_EQ(found.basins.size(), 2U);
  const auto bouncing = std::ranges::find_if(
      found.basins, [](const Basin& basin) { return basin.motion.collisions_per_turn > 0; });
  ASSERT_NE(bouncing, found.basins.end());
  EXPECT_EQ(bouncing->motion.collisions_per_turn, 1);
  EXPECT_EQ(bouncing->turns, 1);
  // In the frame of the table: twice the start over (1 + e) e, by the closed form.
  EXPECT_NEAR(bouncing->motion.fastest_impact, table.start_velocity / restitution, 1e-9);
  const auto sticking = bouncing == found.basins.begin() ? bouncing + 1 : found.basins.begin();
  EXPECT_EQ(sticking->motion.share_at_rest, 1);
  EXPECT_EQ(sticking->starts + bouncing->starts, starts);
  const double expected = bouncing_share(table.omega, starts);
  EXPECT_GT(expected, 0.1);
  EXPECT_LT(expected, 0.9);
  const double deviation = std::sqrt(2 * expected * (1 - expected) / starts);
  EXPECT_NEAR(static_cast<double>(bouncing->starts) / starts, expected, 3.5 * deviation);
}

TEST(Basins, BelowTheFoldEveryBallSticks) {
  const double strength = 0.95 * shaken_table::fold_strength(restitution);
  const Basins found = basins_of(
      shaken_table::on_orbit(restitution, 1.01 * shaken_table::fold_strength(restitution)),
      {1, 1, height, fastest});
  EXPECT_EQ(found.basins.size(), 1U);
  const Scene table =
      at_speed(shaken_table::on_orbit(restitution, 0.6), shaken_table::speed_at(strength));
  const Basins below = basins_of(table, {200, 1, height, fastest});
  ASSERT_EQ(below.basins.size(), 1U);
  EXPECT_EQ(below.basins[0].motion.share_at_rest, 1);
  EXPECT_EQ(below.basins[0].starts, 200);
}

TEST(Basins, TheSeedGivesTheStarts) {
  const Scene table = shaken_table::on_orbit(restitution, 0.6);
  const auto shares = [&](std::uint64_t seed) {
    std::vector<int> starts;
    for (const Basin& basin : basins_of(table, {300, seed, height, fastest}).basins) {
      starts.push_back(basin.starts);
    }
    return starts;
  };
  EXPECT_EQ(shares(3), shares(3));
  EXPECT_NE(shares(3), shares(4));
}

TEST(Basins, ACarrierThatRestsInEveryTurnForgetsItsStart) {
  const Scene machine = at_speed(default_machine(), 6.0);
  const Basins found = basins_of(machine, {100});
  ASSERT_EQ(found.basins.size(), 1U);
  EXPECT_EQ(found.basins[0].motion.collisions_per_turn, most_per_turn(machine));
  EXPECT_EQ(found.height, machine.wall_upper);
}

TEST(Basins, RefusesWhatCannotBeSampled) {
  const auto refuses = [](const Scene& scene, const BasinOptions& options, const char* part) {
    EXPECT_THAT([&] { basins_of(scene, options); }, ThrowsMessage<InputError>(HasSubstr(part)));
  };
  const Scene machine = at_speed(default_machine(), 6.0);
  refuses(machine, {0}, "starts 0: must be within 1..");
  refuses(machine, {10, 1, -1.0}, "height -1");
  refuses(machine, {10, 1, {}, 0.0}, "fastest start 0");
  refuses(shaken_table::on_orbit(restitution, 0.6), {10}, "wall_upper is inf");
  Scene disturbed = machine;
  disturbed.disturbance = 0.1;
  disturbed.disturbance_frequency = 1.2345;
  refuses(disturbed, {10}, "disturbance_frequency");
}

}  // namespace
}  // namespace ricochet::carrier_track
