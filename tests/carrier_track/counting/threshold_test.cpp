#include "problems/carrier_track/counting/threshold.h"

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/count_scan.h"
#include "problems/carrier_track/counting/staircase.h"
#include "ricochet/machine.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

SpeedScan scan_of(std::vector<int> counts) {
  return {1.0, std::move(counts)};
}

TEST(Threshold, AgreesWithTryingEverySplitOnRandomStaircases) {
  std::mt19937_64 random(1);
  int whole = 0;
  for (int trial = 0; trial < 600; ++trial) {
    // Few speeds and many, of which a few, or most, are loud; 4 is at the limit.
    std::vector<int> counts(trial % 2 == 0 ? 40 : 3);
    for (int& c : counts) c = std::uniform_int_distribution(0, trial % 5 == 0 ? 4 : 9)(random);
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
    EXPECT_DOUBLE_EQ(split.misclassified,
                     static_cast<double>(best) / static_cast<double>(counts.size()));
    const bool inside = where > 0 && where < counts.size();
    whole += inside ? 0 : 1;
    ASSERT_EQ(split.speed.has_value(), inside);
    if (inside) {
      EXPECT_DOUBLE_EQ(*split.speed, static_cast<double>(where) + 0.5);
    }
    const auto loud = std::ranges::find_if(counts, [](int c) { return c > 4; });
    ASSERT_EQ(split.first_loud.has_value(), loud != counts.end());
    if (split.first_loud) {
      EXPECT_DOUBLE_EQ(*split.first_loud, static_cast<double>(loud - counts.begin() + 1));
    }
  }
  EXPECT_GT(whole, 100);
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
  std::vector<int> counts;
  for (int k = 1; k <= 12; ++k) counts.push_back(count_at(scene, 0.5 * k));
  EXPECT_EQ(scan_speeds(scene, 0.5, 6.0).counts, counts);
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
  using testing::Field;
  EXPECT_THAT(
      result.examples,
      testing::ElementsAre(AllOf(Field(&Example::loud, false), Field(&Example::right, true)),
                           AllOf(Field(&Example::loud, true), Field(&Example::right, true))));
  EXPECT_GT(result.examples.at(1).count, 2 * result.examples.at(0).count);
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

constexpr double lowest = 0.1, highest = 18;  // [rad/s]

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
  const Scene scene = case_scene(GetParam());
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
  const double upper = 0.00035396882483792406;
  const Scene scene =
      with(case_scene("C5"), set::mass(1.2), set::centrifugal_mass_radius(0.66744559497536),
           set::wall_upper(upper), set::start(upper / 2, 0.3579417139531069),
           set::revolutions(1.3526119703735053), set::counting_limit(0.004505110470351442));
  const auto scan = scan_completely(scene, 8.2, 8.3);
  ASSERT_TRUE(scan);
  const auto narrow = std::count_if(scan->pieces.begin(), scan->pieces.end(), [](const auto& p) {
    return p.to - p.from < 1e-3 && p.from > 8.2;
  });
  EXPECT_EQ(narrow, 2);
}

TEST(CompleteScan, FindsTheFirstSpeedAboveALimit) {
  const Scene scene = case_scene("C1");
  const auto scan = scan_completely(scene, lowest, highest);
  ASSERT_TRUE(scan);
  const double first = scan->first_above(7.5).value().from;
  EXPECT_GT(count_at(scene, first), 7.5);
  EXPECT_LE(count_at(scene, first - 1e-6), 7.5);
  EXPECT_FALSE(scan->first_above(1e6));
}

TEST(CompleteScan, GivesUpWhereItIsNoCheaper) {
  CompleteScanOptions options;
  options.most = 10;
  EXPECT_FALSE(scan_completely(case_scene("C2"), lowest, highest, options));
}

TEST(CompleteScan, RefusesOtherRulesAndModels) {
  const Scene peaks = with(case_scene("C1"), set::rule(CountRule::peaks));
  EXPECT_THROW(scan_completely(peaks, lowest, highest), std::invalid_argument);
}

/// Every speed of an even scan that has a count of at most `most` is in one of the ranges. Returns
/// the number of those speeds.
int expect_held(const Scene& scene, double from, double to, double most,
                const std::vector<CoordinateRange>& ranges) {
  std::vector<double> speeds;
  for (double w = from; w <= to; w += 1e-3) speeds.push_back(w);
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
  const Scene scene = case_scene("C1");
  EXPECT_FALSE(not_excluded(scene, 7, 12, 7).empty());
  EXPECT_TRUE(not_excluded(scene, 8.1, 12, 7).empty());
}

TEST(Exclusion, HoldsEverySpeedThatIsQuiet) {
  int held = 0;
  double excluded = 0;
  RandomScenes random(3107);
  for (int i = 0; i < 12; ++i) {
    const double restitution = random.within(0.1, 0.9), friction = random.within(0.05, 0.4);
    const Scene scene = with(case_scene(i % 2 == 0 ? "C2" : "C9"), set::restitution(restitution),
                             set::friction(friction));
    const double from = random.within(1, 6), to = from + 2;
    const int most = counts_at(scene, std::vector{random.within(from, to)})[0];
    const std::vector<CoordinateRange> ranges = not_excluded(scene, from, to, most);
    held += expect_held(scene, from, to, most, ranges);
    excluded += to - from;
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
