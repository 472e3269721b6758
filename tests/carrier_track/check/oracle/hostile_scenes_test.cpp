#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "problems/carrier_track/check/oracle.h"
#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track {
namespace {

const int kinds = static_cast<int>(all_hostilities().size());

/// Some scenes of a hostility.
std::vector<HostileScene> scenes_of(Hostility hostility, int number) {
  std::vector<HostileScene> scenes;
  for (int i = 0; static_cast<int>(scenes.size()) < number; ++i) {
    if (all_hostilities()[static_cast<std::size_t>(i % kinds)] != hostility) continue;
    scenes.push_back(hostile_scene(3, i));
    EXPECT_EQ(scenes.back().hostility, hostility);
  }
  return scenes;
}

TEST(HostileScenes, AreValidAndEachComputableAlone) {
  std::set<std::string> seen;
  for (int i = 0; i < 20 * kinds; ++i) {
    const Scene scene = hostile_scene(1, i).scene;
    EXPECT_NO_THROW(check(scene, std::to_string(i)));
    EXPECT_TRUE(seen.insert(write_scene(scene)).second) << i;
  }
  for (int i = 20 * kinds; i-- > 0;) {
    EXPECT_TRUE(seen.count(write_scene(hostile_scene(1, i).scene)));
    EXPECT_FALSE(seen.count(write_scene(hostile_scene(2, i).scene)));
  }
}

TEST(HostileScenes, GrazeAsCloselyAsAskedFor) {
  std::set<int> digits;
  int missing = 0;
  for (const HostileScene& h : scenes_of(Hostility::graze, 200)) {
    Scene free = h.scene;
    free.wall_upper = std::numeric_limits<double>::infinity();
    const OracleRun run = oracle_run(free);
    const auto summit = std::min_element(
        run.summits.begin(), run.summits.end(), [&](const Summit& a, const Summit& b) {
          return std::abs(a.height - h.scene.wall_upper) < std::abs(b.height - h.scene.wall_upper);
        });
    ASSERT_NE(summit, run.summits.end());
    const auto distance = static_cast<double>(h.scene.wall_upper / summit->height - 1);
    EXPECT_NEAR(distance, h.closeness, 2e-16);
    digits.insert(static_cast<int>(std::lround(-std::log10(std::abs(h.closeness)))));
    missing += h.closeness > 0;
    // Once it is there, it strikes the wall or turns before it.
    if (std::abs(h.closeness) < 1e-15) continue;
    bool struck = false;
    for (const Impact& i : oracle_run(h.scene).impacts) {
      struck = struck || (i.wall == Wall::upper && i.time < summit->time + 1e-9);
    }
    EXPECT_EQ(struck, h.closeness < 0) << h.closeness;
  }
  EXPECT_EQ(digits.size(), 15U);
  EXPECT_GT(missing, 60);
  EXPECT_LT(missing, 140);
}

TEST(HostileScenes, CountAtTheLimitAsCloselyAsAskedFor) {
  for (const HostileScene& h : scenes_of(Hostility::counting_limit, 100)) {
    double nearest = 1;
    for (const Impact& i : oracle_run(h.scene).impacts) {
      const double distance = h.scene.counting_limit / i.speed - 1;
      if (std::abs(distance) < std::abs(nearest)) nearest = distance;
    }
    EXPECT_LE(std::abs(nearest), std::abs(h.closeness) + 3e-16);
  }
}

TEST(HostileScenes, HoldOrReleaseAtTheLimitOfFriction) {
  for (const HostileScene& h : scenes_of(Hostility::friction_limit, 50)) {
    if (std::abs(h.closeness) < 1e-15) continue;  // less than the rounding of the friction
    Scene scene = h.scene;
    scene.start_velocity = 0;
    scene.start_position = scene.wall_lower = 0;
    scene.wall_upper = 1e-300;  // what moves at all strikes
    scene.window = Seconds{4 * std::numbers::pi / scene.disturbance_frequency};
    // The force peaks in the pull's direction: that must be away from the wall.
    if (scene.pull > 0) {
      scene.pull = -scene.pull;
      scene.disturbance = -scene.disturbance;
    }
    EXPECT_EQ(oracle_run(scene).impacts.empty(), h.closeness > 0) << h.closeness;
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
