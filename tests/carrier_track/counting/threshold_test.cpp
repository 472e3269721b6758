#include "problems/carrier_track/counting/threshold.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <vector>

#include "problems/carrier_track/counting/count.h"
#include "ricochet/machine.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

SpeedScan scan_of(std::vector<int> counts) {
  return {1.0, std::move(counts)};
}

TEST(Threshold, SplitsACleanStaircaseMidwayBetweenItsSpeeds) {
  const Split split = best_split(scan_of({2, 2, 3, 9, 9}), 4.0);
  EXPECT_DOUBLE_EQ(*split.speed, 3.5);
  EXPECT_DOUBLE_EQ(*split.first_loud, 4.0);
  EXPECT_EQ(split.misclassified, 0.0);
}

TEST(Threshold, CountsWhatTheBestSplitGetsWrong) {
  // One loud speed among the quiet ones and one quiet among the loud ones.
  const Split split = best_split(scan_of({2, 9, 2, 2, 9, 9, 2, 9, 9, 9}), 4.0);
  EXPECT_DOUBLE_EQ(*split.speed, 4.5);
  EXPECT_DOUBLE_EQ(*split.first_loud, 2.0);
  EXPECT_DOUBLE_EQ(split.misclassified, 0.2);
}

TEST(Threshold, CallsACountAtTheLimitQuiet) {
  EXPECT_DOUBLE_EQ(*best_split(scan_of({4, 6, 7}), 6.0).speed, 2.5);
}

TEST(Threshold, HasNoSplitWhereAllSpeedsAreBestCalledTheSame) {
  EXPECT_FALSE(best_split(scan_of({2, 2, 2}), 4.0).speed);
  EXPECT_FALSE(best_split(scan_of({2, 2, 2}), 4.0).first_loud);
  const Split loud = best_split(scan_of({9, 9, 2, 9}), 4.0);
  EXPECT_FALSE(loud.speed);
  EXPECT_DOUBLE_EQ(*loud.first_loud, 1.0);
  EXPECT_DOUBLE_EQ(loud.misclassified, 0.25);
}

TEST(Threshold, TakesTheLowestOfEquallyGoodSplits) {
  EXPECT_DOUBLE_EQ(*best_split(scan_of({2, 9, 2, 9}), 4.0).speed, 1.5);
}

TEST(Threshold, AgreesWithTryingEverySplitOnRandomStaircases) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<int> counts(40);
    for (int& c : counts) c = std::uniform_int_distribution(0, 9)(random);
    const Split split = best_split(scan_of(counts), 4.0);
    std::size_t best = counts.size() + 1;
    std::size_t where = 0;
    for (std::size_t quiet = 0; quiet <= counts.size(); ++quiet) {
      std::size_t wrong = 0;
      for (std::size_t k = 0; k < counts.size(); ++k) wrong += (counts[k] > 4) == (k < quiet);
      if (wrong < best) {
        best = wrong;
        where = quiet;
      }
    }
    EXPECT_DOUBLE_EQ(split.misclassified, static_cast<double>(best) / 40.0);
    const bool inside = where > 0 && where < counts.size();
    ASSERT_EQ(split.speed.has_value(), inside);
    if (inside) {
      EXPECT_DOUBLE_EQ(*split.speed, static_cast<double>(where) + 0.5);
    }
  }
}

TEST(Threshold, TakesTheLowestOfEquallyCommonCounts) {
  EXPECT_EQ(most_common({5, 3, 3, 5, 7}), 3);
  EXPECT_FALSE(most_common({}));
}

TEST(Threshold, KeepsEveryTenthSpeedOfAScanWhenThinned) {
  SpeedScan fine{1e-3, {}};
  for (int k = 1; k <= 40; ++k) fine.counts.push_back(k);
  const SpeedScan thin = thinned(fine, 10);
  EXPECT_EQ(thin.counts, (std::vector{10, 20, 30, 40}));
  EXPECT_DOUBLE_EQ(thin.omega(0), 0.01);
}

TEST(Threshold, ScansTheSpeedsItNames) {
  const Scene scene = exploratory_scene();
  const SpeedScan scan = scan_speeds(scene, 0.5, 6.0);
  ASSERT_EQ(scan.counts.size(), 12U);
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    EXPECT_EQ(scan.counts[k], count_at(scene, 0.5 * static_cast<double>(k + 1)));
  }
}

/// Scores a staircase made by hand through the function that scores simulations.
Score score_of(const SpeedScan& scan, const Claim& claim) {
  return score(exploratory_scene(), claim, scan, 1);
}

TEST(Threshold, ScoresEveryPartAsThePaperClaimsIt) {
  // Speeds 1..10; the paper claims a threshold of 5. Below it 4 4 5 9: the usual count is 4.
  Claim claim;
  claim.threshold = 5.0;
  const Score result = score_of(scan_of({4, 4, 5, 9, 4, 6, 8, 9, 10, 12}), claim);
  EXPECT_EQ(result.quiet_count, 4);
  EXPECT_DOUBLE_EQ(*result.purity, 0.75);
  EXPECT_DOUBLE_EQ(*result.threshold, 6.5);  // quiet is <= 6
  EXPECT_DOUBLE_EQ(result.misclassified, 0.1);
  EXPECT_DOUBLE_EQ(*result.loudness, 9.0 / 4.0);  // median of 6 8 9 10 12
  EXPECT_DOUBLE_EQ(*result.first_loud, 4.0);
}

TEST(Threshold, TakesTheQuietCountFromTheLowestTenthWhereNothingIsClaimed) {
  std::vector<int> counts(100, 9);
  std::fill_n(counts.begin(), 9, 2);
  const Score result = score_of({0.1, counts}, {});
  EXPECT_EQ(result.quiet_count, 2);
  EXPECT_NEAR(*result.threshold, 0.95, 1e-12);
  EXPECT_DOUBLE_EQ(*result.purity, 1.0);
  EXPECT_DOUBLE_EQ(*result.loudness, 4.5);
  EXPECT_TRUE(result.examples.empty());
}

TEST(Threshold, FindsTheQuietCountWithoutTheSpeedsAboveTheReference) {
  const Case a_case = find_case("C2");
  const Scene scene = scene_of(a_case, exploratory_scene());
  const ScanOptions options{.step = 0.01, .stride = 1, .highest = 4.0};
  EXPECT_EQ(quiet_count(scene, a_case.claim, options),
            score(scene, a_case.claim, options).quiet_count);
}

TEST(Threshold, PutsTheExamplesOfAFigureOnTheirSides) {
  const Case a_case = find_case("C2");
  const Score result = score(scene_of(a_case, exploratory_scene()), a_case.claim,
                             {.step = 0.05, .stride = 1, .highest = 18.0});
  ASSERT_EQ(result.examples.size(), 2U);
  EXPECT_FALSE(result.examples[0].loud);
  EXPECT_TRUE(result.examples[0].right);
  EXPECT_TRUE(result.examples[1].loud);
  EXPECT_TRUE(result.examples[1].right);
  EXPECT_GT(result.examples[1].count, 2 * result.examples[0].count);
}

class EveryCase : public testing::TestWithParam<Case> {};

TEST_P(EveryCase, HasTheThresholdOfAnExhaustiveScan) {
  const Case& a_case = GetParam();
  const Scene scene = scene_of(a_case, exploratory_scene());
  const Score result = score(scene, a_case.claim, ScanOptions{});
  ASSERT_TRUE(result.threshold.has_value());
  const double limit = quiet_limit(result.quiet_count);
  // One speed after the other, counted from the impacts; loud_below[k] of the first k are loud.
  std::vector<int> loud_below = {0};
  std::optional<double> first_loud;
  for (int k = 1; k <= 18000; ++k) {
    Scene turning = scene;
    turning.omega = k * 1e-3;
    const bool loud = objective(turning, 0.0) > limit;
    if (loud && !first_loud) first_loud = turning.omega;
    loud_below.push_back(loud_below.back() + (loud ? 1 : 0));
  }
  ASSERT_TRUE(first_loud.has_value());
  EXPECT_NEAR(*result.first_loud, *first_loud, 1e-9);
  const auto wrong = [&](int quiet) {
    const int quiet_above =
        18000 - quiet - (loud_below.back() - loud_below[static_cast<std::size_t>(quiet)]);
    return loud_below[static_cast<std::size_t>(quiet)] + quiet_above;
  };
  const auto found = static_cast<int>(*result.threshold / 1e-3);
  for (int quiet = 0; quiet <= 18000; ++quiet) ASSERT_LE(wrong(found), wrong(quiet)) << quiet;
}

INSTANTIATE_TEST_SUITE_P(Threshold, EveryCase, testing::ValuesIn(all_cases()),
                         [](const auto& tested) { return tested.param.id; });

}  // namespace
}  // namespace ricochet::carrier_track
