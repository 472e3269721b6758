#include "problems/carrier_track/regimes/regime_map.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "ricochet/evaluator.h"
#include "ricochet/random.h"
#include "tests/carrier_track/regimes/long_simulation.h"
#include "tests/carrier_track/regimes/random_machine.h"

namespace ricochet::carrier_track {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Scene machine_of(const std::string& id) {
  return scene_of(find_case(id), default_machine());
}

/// Columns of a map that are compared with the regimes of their machines: cells, and those of them
/// that differ though no border is as near as half a cell, and the motion is certain.
struct Compared {
  int cells = 0, wrong = 0;
};

Compared compared_with_regimes(const Scene& machine, const RegimeMap& map, std::size_t every) {
  Compared result;
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
      ++result.cells;
      if (!cell || std::abs(*cell - regime.most_per_turn) > 1e-9) ++result.wrong;
    }
  }
  return result;
}

RegimeMapOptions over_restitution() {
  return {{"restitution", 0.05, 0.95}, 31, {"omega", 0.5, 12}};
}

const RegimeMap& map_of_c1() {
  static const RegimeMap map = regime_map(machine_of("C1"), over_restitution());
  return map;
}

TEST(RegimeMap, HasTheRegimesOfItsMachinesInItsCells) {
  const Compared c1 = compared_with_regimes(machine_of("C1"), map_of_c1(), 3);
  EXPECT_GT(c1.cells, 1000);
  EXPECT_EQ(c1.wrong, 0);
}

TEST(RegimeMap, HasTheRegimesOfMachinesOfAnyKind) {
  Compared all;
  for (const int seed : {1, 5, 7, 10, 15}) {
    const Scene machine = random_machine(static_cast<std::uint64_t>(seed));
    const double limit = machine.counting_limit;
    const RegimeMap map =
        regime_map(machine, {{"counting_limit", 0.5 * limit, 2 * limit}, 3, {"omega", 0.5, 6}});
    const auto [cells, wrong] = compared_with_regimes(machine, map, 1);
    all.cells += cells;
    all.wrong += wrong;
  }
  EXPECT_GT(all.cells, 1000);
  // Where several motions are possible, a step of a cell may lead to another one.
  EXPECT_LT(100 * all.wrong, all.cells) << "of " << all.cells;
}

TEST(RegimeMap, HasTheMostCollisionsOfDisturbedMachines) {
  const Scene machine = machine_of("C5");
  const RegimeMap map = regime_map(machine, {{"restitution", 0.1, 0.2}, 2, {"omega", 1, 4}});
  EXPECT_TRUE(map.disturbed);
  EXPECT_FALSE(map.followed);
  const auto [cells, wrong] = compared_with_regimes(machine, map, 1);
  EXPECT_GT(cells, 100);
  EXPECT_EQ(wrong, 0);
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

TEST(RegimeMap, HasTheBordersOfTheMachineItself) {
  const RegimeMap& map = map_of_c1();
  EXPECT_TRUE(map.followed);
  EXPECT_EQ(map.own, 0.1);
  const std::vector<Regime> regimes = regimes_of(machine_of("C1"), {0.5, 12});
  ASSERT_EQ(map.curves.size() + 1, regimes.size());
  for (std::size_t i = 0; i < map.curves.size(); ++i) EXPECT_EQ(map.curves[i].own, regimes[i].to);
}

TEST(RegimeMap, HasThePointsAndSlopesOfBordersSolvedAnew) {
  const Scene machine = machine_of("C1");
  const auto quiet = [&](double restitution) {
    Scene other = machine;
    other.restitution_lower = other.restitution_upper = restitution;
    return *quiet_up_to(other, 2, {0.5, 12});
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
  const Scene machine = at_speed(machine_of("C1"), 6.0);
  const RegimeMap map =
      regime_map(machine, {{"restitution", 0.1, 0.4}, 4, {"friction", 0.05, 0.5}});
  EXPECT_FALSE(map.followed);
  std::vector<double> counts;
  for (const MapColumn& column : map.columns) {
    for (std::size_t k = 0; k < map.heights.size(); k += 7) {
      Scene other = machine;
      set_constant(other, "restitution", column.value);
      other.friction = map.heights[k];
      counts.push_back(most_per_turn(other));
      EXPECT_EQ(column.cells[k], counts.back()) << column.value << " " << map.heights[k];
    }
  }
  EXPECT_LT(*std::ranges::min_element(counts), *std::ranges::max_element(counts));
}

TEST(RegimeMap, KeepsTheCellsThatHadTime) {
  const TimeLimit limit(1e-9);
  const RegimeMap map = regime_map(machine_of("C1"), over_restitution());
  EXPECT_FALSE(map.complete);
  EXPECT_EQ(map.columns.size(), 31U);
  EXPECT_LT(map.columns.front().cells.size(), map.heights.size());
}

TEST(RegimeMap, RefusesWhatIsNoRangeOfMachines) {
  const Scene machine = machine_of("C1");
  const auto refuses = [&](const RegimeMapOptions& options, const char* part) {
    EXPECT_THAT([&] { regime_map(machine, options); }, ThrowsMessage<InputError>(HasSubstr(part)));
  };
  refuses({{"restitution", 0.5, 1.5}}, "restitution");
  refuses({{"restitution", 0.5, 0.5}}, "must rise");
  refuses({{"wall_lower", 0, 1}}, "clearance");
  refuses({{"clearance", -1e-3, 1e-3}}, "clearance");
  refuses({{"restitution", 0.1, 0.5}, 1}, "values");
  refuses({{"restitution", 0.1, 0.5}, 5, {"restitution", 0, 1}}, "two different");
  refuses({{"restitution", 0.1, 0.5}, 5, {"omega", 0, 1}}, "omega");
}

}  // namespace
}  // namespace ricochet::carrier_track
