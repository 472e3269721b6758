#include "problems/carrier_track/regimes/regime_map.h"

#include "problems/carrier_track/regimes/basins.h"
#include "problems/carrier_track/regimes/followed_motion.h"
#include "ricochet/evaluator.h"
#include "ricochet/random.h"
#include "tests/carrier_track/regimes/machines.h"
#include "tests/support/refusals.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

/// Compares every so-manieth column of a map with the regimes of its machine; returns the number of
/// cells, and of those that differ though no border is as near as half a cell, and the motion is
/// certain.
std::pair<int, int> compared_with_regimes(const Scene& machine, const RegimeMap& map,
                                          std::size_t every) {
  int cells = 0, wrong = 0;
  const auto& [over, values, against] = map.options;
  const double half = (map.heights[1] - map.heights[0]) / 2;
  for (std::size_t i = 0; i < map.columns.size(); i += every) {
    Scene other = machine;
    set_constant(other, over.key, map.columns[i].value);
    const std::vector<Regime> regimes = regimes_of(other, {against.from, against.to});
    for (std::size_t k = 0; k < map.heights.size(); ++k) {
      const double speed = map.heights[k];
      const Regime& regime = regime_at(regimes, speed);
      if (!regime.certain || speed - half < regime.from || speed + half > regime.to) continue;
      const std::optional<double> cell = map.columns[i].cells[k];
      ++cells;
      if (!cell || std::abs(*cell - regime.most_per_turn) > 1e-9) ++wrong;
    }
  }
  return {cells, wrong};
}

RegimeMapOptions over_restitution() {
  return {{"restitution", 0.05, 0.95}, 31, {"omega", 0.5, 12}};
}

const RegimeMap& map_of_c1() {
  static const RegimeMap map = regime_map(case_scene("C1"), over_restitution());
  return map;
}

TEST(RegimeMap, HasTheRegimesAndBordersOfItsMachines) {
  const RegimeMap& map = map_of_c1();
  EXPECT_THAT(compared_with_regimes(case_scene("C1"), map, 3), FieldsAre(testing::Gt(1000), 0));
  EXPECT_TRUE(map.followed);
  EXPECT_EQ(map.own, 0.1);
  const std::vector<Regime> regimes = regimes_of(case_scene("C1"), {0.5, 12});
  ASSERT_EQ(map.curves.size() + 1, regimes.size());
  for (std::size_t i = 0; i < map.curves.size(); ++i) EXPECT_EQ(map.curves[i].own, regimes[i].to);
}

TEST(RegimeMap, HasTheRegimesOfMachinesOfAnyKind) {
  int all = 0, all_wrong = 0;
  for (const std::uint64_t seed : {1U, 5U, 7U, 10U, 15U}) {
    const Scene machine = random_machine(seed);
    const double limit = machine.counting_limit;
    const RegimeMap map =
        regime_map(machine, {{"counting_limit", 0.5 * limit, 2 * limit}, 3, {"omega", 0.5, 6}});
    const auto [cells, wrong] = compared_with_regimes(machine, map, 1);
    all += cells;
    all_wrong += wrong;
  }
  EXPECT_GT(all, 1000);
  // Where several motions are possible, a step of a cell may lead to another one.
  EXPECT_LT(100 * all_wrong, all);
}

TEST(RegimeMap, HasTheMostCollisionsOfDisturbedMachines) {
  const Scene machine = case_scene("C5");
  const RegimeMap map = regime_map(machine, {{"restitution", 0.1, 0.2}, 2, {"omega", 1, 4}});
  EXPECT_TRUE(map.disturbed);
  EXPECT_FALSE(map.followed);
  EXPECT_THAT(compared_with_regimes(machine, map, 1), FieldsAre(testing::Gt(100), 0));
  ASSERT_FALSE(map.curves.empty());
  const double half = (map.heights[1] - map.heights[0]) / 2;
  for (const MapCurve& curve : map.curves) {
    for (const MapPoint& point : curve.points) {
      const MapColumn& column = *std::ranges::find(map.columns, point.constant, &MapColumn::value);
      for (std::size_t k = 0; k < map.heights.size() && map.heights[k] < point.omega + half * 1.5;
           ++k)
        EXPECT_EQ(column.cells[k] > curve.slower, map.heights[k] > point.omega);
    }
  }
}

TEST(RegimeMap, HasThePointsAndSlopesOfBordersSolvedAnew) {
  const Scene machine = case_scene("C1");
  const auto quiet = [&](double restitution) {
    return *quiet_up_to(with(machine, set::restitution(restitution)), 2, {0.5, 12});
  };
  const auto curve = std::ranges::find(map_of_c1().curves, 2.0, &MapCurve::slower);
  ASSERT_NE(curve, map_of_c1().curves.end());
  ASSERT_GT(curve->points.size(), 100U);
  EXPECT_EQ(curve->begins, CurveEnd::speeds);
  EXPECT_EQ(curve->ends, CurveEnd::range);
  for (std::size_t i = 0; i < curve->points.size(); i += 13) {
    const MapPoint& point = curve->points[i];
    EXPECT_NEAR(quiet(point.constant) / point.omega, 1, 1e-10) << point.constant;
    ASSERT_TRUE(point.slope);
    const double step = 1e-5;
    EXPECT_NEAR(*point.slope,
                (quiet(point.constant + step) - quiet(point.constant - step)) / (2 * step),
                1e-4 * std::abs(*point.slope));
  }
}

TEST(RegimeMap, OfTwoConstantsIsThatOfTheirMachines) {
  const Scene machine = at_speed(case_scene("C1"), 6.0);
  const RegimeMap map =
      regime_map(machine, {{"restitution", 0.1, 0.4}, 4, {"friction", 0.05, 0.5}});
  EXPECT_FALSE(map.followed);
  std::set<double> counts;
  for (const MapColumn& column : map.columns) {
    for (std::size_t k = 0; k < map.heights.size(); k += 7) {
      Scene other = machine;
      set_constant(other, "restitution", column.value);
      other.friction = map.heights[k];
      const double most = most_per_turn(other);
      EXPECT_EQ(column.cells[k], most) << column.value << " " << map.heights[k];
      counts.insert(most);
    }
  }
  EXPECT_GT(counts.size(), 1U);
}

TEST(RegimeMap, KeepsTheCellsThatHadTime) {
  const TimeLimit limit(1e-9);
  const RegimeMap map = regime_map(case_scene("C1"), over_restitution());
  EXPECT_FALSE(map.complete);
  EXPECT_EQ(map.columns.size(), 31U);
  EXPECT_LT(map.columns.front().cells.size(), map.heights.size());
}

TEST(RegimeMap, RefusesWhatIsNoRangeOfMachines) {
  expect_refusals<InputError, RegimeMapOptions>(
      [](const RegimeMapOptions& options) { regime_map(case_scene("C1"), options); },
      {{{{"restitution", 0.5, 1.5}}, "restitution"},
       {{{"restitution", 0.5, 0.5}}, "must rise"},
       {{{"wall_lower", 0, 1}}, "clearance"},
       {{{"clearance", -1e-3, 1e-3}}, "clearance"},
       {{{"restitution", 0.1, 0.5}, 1}, "values"},
       {{{"restitution", 0.1, 0.5}, 5, {"restitution", 0, 1}}, "two different"},
       {{{"restitution", 0.1, 0.5}, 5, {"omega", 0, 1}}, "omega"}});
}

constexpr double height = 0.03, fastest = 1.0, restitution = 0.8;  // m, m/s

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
  Random random(99);
  int kept_bouncing = 0;
  for (int i = 0; i < starts; ++i) {
    const double phase = 2 * std::numbers::pi * uniform(random);
    const double above = height * uniform(random);
    const double velocity = fastest * (2 * uniform(random) - 1);
    kept_bouncing += bounces(table.omega, phase, above, velocity);
  }
  const double expected = static_cast<double>(kept_bouncing) / starts;
  EXPECT_TRUE(expected > 0.1 && expected < 0.9) << expected;
  const double deviation = std::sqrt(2 * expected * (1 - expected) / starts);
  EXPECT_NEAR(static_cast<double>(bouncing->starts) / starts, expected, 3.5 * deviation);
}

TEST(Basins, BelowTheFoldEveryBallSticks) {
  const double fold = shaken_table::fold_strength(restitution);
  const Scene above = shaken_table::on_orbit(restitution, 1.01 * fold);
  EXPECT_EQ(basins_of(above, {1, 1, height, fastest}).basins.size(), 1U);
  const Scene table =
      at_speed(shaken_table::on_orbit(restitution, 0.6), shaken_table::speed_at(0.95 * fold));
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
  EXPECT_EQ(steady_motion(machine).rest, Rest::on_a_wall);
  EXPECT_EQ(found.height, machine.wall_upper);
}

TEST(Basins, RefusesWhatCannotBeSampled) {
  const Scene machine = at_speed(default_machine(), 6.0);
  using Sampled = std::pair<Scene, BasinOptions>;
  expect_refusals<InputError, Sampled>(
      [](const Sampled& sampled) { return basins_of(sampled.first, sampled.second); },
      {{{machine, {0}}, "starts 0: must be within 1.."},
       {{machine, {10, 1, -1.0}}, "height -1"},
       {{machine, {10, 1, {}, 0.0}}, "fastest start 0"},
       {{shaken_table::on_orbit(restitution, 0.6), {10}}, "wall_upper is inf"},
       {{with(machine, set::disturbance(0.1), set::disturbance_frequency(1.2345)), {10}},
        "disturbance_frequency"}});
}

Anatomy anatomy_at(double omega, double turns) {
  const Scene machine = with(default_machine(), set::omega(omega), set::revolutions(turns));
  return anatomy_of(machine, simulate(machine).impacts).value();
}

TEST(Anatomy, IsADecayAndTwoCollisionsATurn) {
  const double turns = std::get<Revolutions>(default_machine().window).count;
  const auto counted = [](double window) {
    return simulate(with(default_machine(), set::omega(5), set::revolutions(window))).count;
  };
  const Anatomy anatomy = anatomy_at(5, turns);
  EXPECT_EQ(anatomy.of_start + anatomy.of_long_run, counted(turns));
  EXPECT_EQ(anatomy.per_turn, 2);
  EXPECT_GT(anatomy.of_start, 0);
  // A later window of as many turns has nothing but the long run, a long one as much decay.
  EXPECT_EQ(counted(100 + turns) - counted(100), anatomy.of_long_run);
  const Anatomy brief = anatomy_at(3, 3), longer = anatomy_at(3, 30);
  EXPECT_EQ(brief.of_start, longer.of_start);
  EXPECT_EQ(longer.of_long_run - brief.of_long_run, 2 * 27);
  const Scene shaken = with(default_machine(), set::disturbance(0.1), set::omega(5.0123));
  EXPECT_FALSE(anatomy_of(shaken, simulate(shaken).impacts)) << "without a period it is unknown";
}

}  // namespace
}  // namespace ricochet::carrier_track
