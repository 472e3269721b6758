#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count_scan.h"
#include "problems/carrier_track/counting/staircase.h"
#include "problems/carrier_track/suite/machine.h"

namespace ricochet::carrier_track {
namespace {

/// Every speed of an even scan that has a count of at most `most` is in one of the ranges. Returns
/// the number of those speeds.
int expect_held(const Scene& scene, double lowest, double highest, double most,
                const std::vector<CoordinateRange>& ranges) {
  std::vector<double> speeds;
  for (double w = lowest; w <= highest; w += 1e-3) speeds.push_back(w);
  const std::vector<int> counts = counts_at(scene, speeds);
  int held = 0;
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    if (counts[k] > most) continue;
    ++held;
    // Speeds between two pieces of a scan are known to its resolution only.
    EXPECT_TRUE(std::ranges::any_of(ranges, [&](const CoordinateRange& range) {
      return speeds[k] >= range.from - 2e-6 && speeds[k] <= range.to + 2e-6;
    })) << speeds[k];
  }
  return held;
}

TEST(Exclusion, LeavesNothingWhereEverySpeedIsLoud) {
  const Scene scene = scene_of(find_case("C1"), default_machine());
  EXPECT_FALSE(not_excluded(scene, 7, 12, 7).empty());
  EXPECT_TRUE(not_excluded(scene, 8.1, 12, 7).empty());
}

TEST(Exclusion, HoldsEverySpeedThatIsQuiet) {
  int held = 0;
  double excluded = 0;
  RandomScenes random(3107);
  for (int i = 0; i < 12; ++i) {
    Scene scene = scene_of(find_case(i % 2 == 0 ? "C2" : "C9"), default_machine());
    scene.restitution_lower = scene.restitution_upper = random.within(0.1, 0.9);
    scene.friction = random.within(0.05, 0.4);
    const double lowest = random.within(1, 6), highest = lowest + 2;
    const int most = counts_at(scene, std::vector{random.within(lowest, highest)})[0];
    const std::vector<CoordinateRange> ranges = not_excluded(scene, lowest, highest, most);
    held += expect_held(scene, lowest, highest, most, ranges);
    excluded += highest - lowest;
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      excluded -= ranges[k].to - ranges[k].from;
      EXPECT_LE(ranges[k].from, ranges[k].to);
      if (k > 0) {
        EXPECT_GT(ranges[k].from, ranges[k - 1].to);
      }
    }
  }
  EXPECT_GT(held, 1000);
  EXPECT_GT(excluded, 1);
}

}  // namespace
}  // namespace ricochet::carrier_track
