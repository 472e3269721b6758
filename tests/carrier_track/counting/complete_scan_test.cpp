#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count_scan.h"
#include "problems/carrier_track/counting/staircase.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track {
namespace {

constexpr double lowest = 0.1;
constexpr double highest = 18;

/// Every `step`-th speed from one on [rad/s] must have the count of its piece.
void expect_counts(const Scene& scene, const CompleteScan& scan, double from, double step,
                   int speeds) {
  std::vector<double> at;
  for (int k = 0; k < speeds; ++k) at.push_back(std::min(from + step * k, highest));
  const std::vector<int> counts = counts_at(scene, at);
  for (std::size_t k = 0; k < at.size(); ++k) {
    const auto piece = std::lower_bound(scan.pieces.begin(), scan.pieces.end(), at[k],
                                        [](const CountPiece& p, double w) { return p.to < w; });
    ASSERT_NE(piece, scan.pieces.end());
    if (at[k] < piece->from) continue;  // between two pieces
    ASSERT_EQ(counts[k], piece->count) << at[k] << " rad/s";
  }
}

/// All speeds 1e-3 rad/s apart, and those 1e-6 rad/s apart near every step and at random.
void expect_complete(const Scene& scene, const CompleteScan& scan, RandomScenes& random) {
  expect_counts(scene, scan, lowest, 1e-3, 17'900);
  for (const CountPiece& piece : scan.pieces) {
    if (piece.from > 2 * lowest) expect_counts(scene, scan, piece.from - 2e-4, 1e-6, 400);
  }
  for (int i = 0; i < 10; ++i) {
    expect_counts(scene, scan, random.within(lowest, highest - 1e-3), 1e-6, 500);
  }
}

void expect_whole(const CompleteScan& scan, double resolution) {
  ASSERT_FALSE(scan.pieces.empty());
  EXPECT_EQ(scan.pieces.front().from, lowest);
  EXPECT_EQ(scan.pieces.back().to, highest);
  for (std::size_t k = 1; k < scan.pieces.size(); ++k) {
    EXPECT_NE(scan.pieces[k].count, scan.pieces[k - 1].count);
    EXPECT_GT(scan.pieces[k].from, scan.pieces[k - 1].to);
    EXPECT_LE(scan.pieces[k].from - scan.pieces[k - 1].to, resolution);
  }
}

class CompleteScanOfCase : public testing::TestWithParam<const char*> {};

TEST_P(CompleteScanOfCase, HoldsAtEverySpeedLookedAt) {
  const Scene scene = scene_of(find_case(GetParam()), default_machine());
  const auto scan = scan_completely(scene, lowest, highest);
  ASSERT_TRUE(scan);
  EXPECT_LT(scan->simulations, 2500);
  expect_whole(*scan, 1e-6);
  RandomScenes random(3);
  expect_complete(scene, *scan, random);
}

INSTANTIATE_TEST_SUITE_P(SomeCases, CompleteScanOfCase,
                         testing::Values("C1", "C4", "C5", "C9", "C12"),
                         [](const auto& of) { return std::string(of.param); });

TEST(CompleteScan, HoldsAtEverySpeedLookedAtInRandomScenes) {
  RandomScenes random(77);
  CompleteScanOptions options;
  options.most = 2000;
  int complete = 0;
  for (int i = 0; i < 12; ++i) {
    const Scene scene = random.next();
    const auto scan = scan_completely(scene, lowest, highest, options);
    if (!scan) continue;
    ++complete;
    SCOPED_TRACE(i);
    expect_whole(*scan, options.resolution);
    expect_complete(scene, *scan, random);
  }
  EXPECT_GE(complete, 5);
}

TEST(CompleteScan, SeesThatAStepOfTwoIsTwoStepsOfOne) {
  // The steps of this machine are 1.3e-4 rad/s apart: an even scan has one of them.
  Scene scene = scene_of(find_case("C5"), default_machine());
  scene.mass = 1.2;
  scene.centrifugal_mass_radius = 0.66744559497536;
  scene.wall_upper = 0.00035396882483792406;
  scene.start_position = scene.wall_upper / 2;
  scene.start_velocity = 0.3579417139531069;
  scene.window = Revolutions{1.3526119703735053};
  scene.counting_limit = 0.004505110470351442;
  const auto scan = scan_completely(scene, 8.2, 8.3);
  ASSERT_TRUE(scan);
  const auto narrow = std::count_if(scan->pieces.begin(), scan->pieces.end(), [](const auto& p) {
    return p.to - p.from < 1e-3 && p.from > 8.2;
  });
  EXPECT_EQ(narrow, 2);
}

TEST(CompleteScan, FindsTheFirstSpeedAboveALimit) {
  const Scene scene = scene_of(find_case("C1"), default_machine());
  const auto scan = scan_completely(scene, lowest, highest);
  ASSERT_TRUE(scan);
  const double first = scan->first_above(7.5).value().from;
  EXPECT_GT(count_at(scene, first), 7.5);
  EXPECT_LE(count_at(scene, first - 1e-6), 7.5);
  EXPECT_FALSE(scan->first_above(1e6));
}

TEST(CompleteScan, GivesUpWhereItIsNoCheaper) {
  const Scene scene = scene_of(find_case("C2"), default_machine());
  CompleteScanOptions options;
  options.most = 10;
  EXPECT_FALSE(scan_completely(scene, lowest, highest, options));
}

TEST(CompleteScan, RefusesOtherRulesAndModels) {
  Scene scene = scene_of(find_case("C1"), default_machine());
  scene.rule = CountRule::peaks;
  EXPECT_THROW(scan_completely(scene, lowest, highest), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet::carrier_track
