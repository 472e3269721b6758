#include "problems/carrier_track/regimes/regime_map.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "ricochet/random.h"
#include "tests/carrier_track/regimes/random_machine.h"

namespace ricochet::carrier_track {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Scene machine_of(const std::string& id) {
  return scene_of(find_case(id), default_machine());
}

RegimeMapOptions over_restitution() {
  return {"restitution", 0.05, 0.95, 31, {0.5, 12}};
}

/// Whether a border of the map is this near [relative, of the speed].
bool is_beside_a_border(const RegimeMap& map, double constant, double omega, double reach) {
  for (const MapRegion& region : map.regions) {
    for (std::size_t i = 0; i + 1 < region.edges.size(); ++i) {
      const auto& a = region.edges[i];
      const auto& b = region.edges[i + 1];
      if (constant < a.constant || constant > b.constant || a.constant == b.constant) continue;
      const double share = (constant - a.constant) / (b.constant - a.constant);
      for (const double edge :
           {a.lower + share * (b.lower - a.lower), a.upper + share * (b.upper - a.upper)}) {
        if (std::abs(edge / omega - 1) < reach) return true;
      }
    }
  }
  return false;
}

TEST(RegimeMap, AgreesWithLongSimulationsAtRandomPoints) {
  const Scene machine = machine_of("C1");
  const RegimeMap map = regime_map(machine, over_restitution());
  Random random(1);
  int checked = 0;
  for (int i = 0; i < 400; ++i) {
    const double restitution = 0.05 + 0.9 * uniform(random);
    const double omega = 0.5 + 11.5 * uniform(random);
    const std::optional<double> found = map.collisions_at(restitution, omega);
    ASSERT_TRUE(found) << restitution << " " << omega;
    if (is_beside_a_border(map, restitution, omega, 2e-3)) continue;
    ++checked;
    Scene other = machine;
    other.restitution_lower = other.restitution_upper = restitution;
    EXPECT_EQ(*found, collisions_in_the_long_run(other, omega, 60, 20))
        << "restitution " << restitution << ", speed " << omega;
  }
  EXPECT_GT(checked, 350);
}

TEST(RegimeMap, HasTheBordersOfTheMachineItself) {
  const Scene machine = machine_of("C1");
  const RegimeMap map = regime_map(machine, over_restitution());
  EXPECT_TRUE(map.followed);
  EXPECT_EQ(map.own, 0.1);
  std::vector<double> own;
  for (const MapCurve& curve : map.curves)
    if (curve.own) own.push_back(*curve.own);
  std::ranges::sort(own);
  const std::vector<Regime> regimes = regimes_of(machine, over_restitution().speeds);
  ASSERT_EQ(own.size() + 1, regimes.size());
  for (std::size_t i = 0; i < own.size(); ++i) EXPECT_NEAR(own[i] / regimes[i].to, 1, 1e-10);
}

TEST(RegimeMap, HasThePointsAndSlopesOfBordersSolvedAnew) {
  const Scene machine = machine_of("C1");
  const RegimeMap map = regime_map(machine, over_restitution());
  const auto quiet = [&](double restitution) {
    Scene other = machine;
    other.restitution_lower = other.restitution_upper = restitution;
    return *quiet_up_to(other, 2, over_restitution().speeds);
  };
  const auto curve = std::ranges::find_if(
      map.curves, [&](const MapCurve& a_curve) { return a_curve.own && a_curve.slower == 2; });
  ASSERT_NE(curve, map.curves.end());
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

TEST(RegimeMap, CoversEveryPointOfMachinesOfAnyKind) {
  for (const int seed : {1, 5, 7, 10, 15}) {
    const Scene machine = random_machine(static_cast<std::uint64_t>(seed));
    const double limit = machine.counting_limit;
    const RegimeMap map =
        regime_map(machine, {"counting_limit", 0.5 * limit, 2 * limit, 7, {0.5, 6}});
    Random random(2);
    int checked = 0, wrong = 0;
    for (int i = 0; i < 100; ++i) {
      const double value = limit * (0.5 + 1.5 * uniform(random));
      const double omega = 0.5 + 5.5 * uniform(random);
      const std::optional<double> found = map.collisions_at(value, omega);
      ASSERT_TRUE(found) << seed << ": " << value << " " << omega;
      if (is_beside_a_border(map, value, omega, 1e-2)) continue;
      Scene other = machine;
      other.counting_limit = value;
      ++checked;
      if (std::abs(*found - most_per_turn(at_speed(other, omega))) > 1e-9) ++wrong;
    }
    EXPECT_LE(wrong, checked / 20) << seed << ": of " << checked;
  }
}

TEST(RegimeMap, JoinsTheBordersOfDisturbedMachines) {
  const Scene machine = machine_of("C5");
  const RegimeMap map = regime_map(machine, {"restitution", 0.1, 0.2, 3, {1, 4}});
  EXPECT_FALSE(map.followed);
  ASSERT_FALSE(map.curves.empty());
  for (const MapCurve& curve : map.curves) EXPECT_FALSE(curve.points.front().slope);
  const std::vector<Regime> regimes = regimes_of(machine, {1, 4});
  for (const Regime& regime : regimes) {
    EXPECT_EQ(map.collisions_at(0.1, 0.5 * (regime.from + regime.to)), regime.most_per_turn);
  }
}

TEST(RegimeMap, RefusesWhatIsNoRangeOfMachines) {
  const Scene machine = machine_of("C1");
  const auto refuses = [&](const RegimeMapOptions& options, const char* part) {
    EXPECT_THAT([&] { regime_map(machine, options); }, ThrowsMessage<InputError>(HasSubstr(part)));
  };
  refuses({"restitution", 0.5, 1.5}, "restitution");
  refuses({"restitution", 0.5, 0.5}, "must rise");
  refuses({"wall_lower", 0, 1}, "clearance");
  refuses({"clearance", -1e-3, 1e-3}, "clearance");
  refuses({"restitution", 0.1, 0.5, 1}, "values");
}

}  // namespace
}  // namespace ricochet::carrier_track
