#include "problems/carrier_track/counting/threshold.h"

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/count_scan.h"
#include "problems/carrier_track/counting/staircase.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

/// How many counts are on the wrong side if none, the first, the first two ... are called quiet.
std::vector<int> misclassified_by_splits(const std::vector<int>& counts, double limit) {
  std::vector<int> wrong = {0};
  for (const int count : counts) wrong[0] += count <= limit ? 1 : 0;
  for (const int count : counts) wrong.push_back(wrong.back() + (count > limit ? 1 : -1));
  return wrong;
}

TEST(Threshold, AgreesWithTryingEverySplitOnRandomStaircases) {
  std::mt19937_64 random(1);
  int whole = 0;
  for (int trial = 0; trial < 600; ++trial) {
    // Few speeds and many, of which a few, or most, are loud; 4 is at the limit.
    std::vector<int> counts(trial % 2 == 0 ? 40 : 3);
    for (int& c : counts) c = std::uniform_int_distribution(0, trial % 5 == 0 ? 4 : 9)(random);
    const Split split = best_split({1.0, counts}, 4.0);
    const std::vector<int> wrong = misclassified_by_splits(counts, 4.0);
    const auto best = std::ranges::min_element(wrong);
    EXPECT_DOUBLE_EQ(split.misclassified, *best / static_cast<double>(counts.size()));
    const bool inside = best != wrong.begin() && best + 1 != wrong.end();
    whole += inside ? 0 : 1;
    EXPECT_EQ(split.speed, inside ? std::optional(static_cast<double>(best - wrong.begin()) + 0.5)
                                  : std::nullopt);
    const auto loud = std::ranges::find_if(counts, [](int c) { return c > 4; });
    EXPECT_EQ(split.first_loud, loud != counts.end()
                                    ? std::optional(static_cast<double>(loud - counts.begin() + 1))
                                    : std::nullopt);
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
  const Score result = score_of({1.0, {4, 4, 5, 9, 4, 6, 8, 9, 10, 12}}, claim);
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
  EXPECT_THAT(result.examples,
              ElementsAre(AllOf(Field(&Example::loud, false), Field(&Example::right, true)),
                          AllOf(Field(&Example::loud, true), Field(&Example::right, true))));
  EXPECT_GT(result.examples.at(1).count, 2 * result.examples.at(0).count);
}

TEST(Threshold, HasTheThresholdOfAnExhaustiveScan) {
  for (const Case& a_case : all_cases()) {
    SCOPED_TRACE(a_case.id);
    Scene scene = scene_of(a_case, exploratory_scene());
    const Score result = score(scene, a_case.claim, ScanOptions{});
    const double limit = quiet_limit(result.quiet_count);
    // One speed after the other, counted from the impacts.
    std::vector<int> counts;
    for (int k = 1; k <= 18000; ++k) {
      scene.omega = k * 1e-3;
      counts.push_back(static_cast<int>(objective(scene, 0.0)));
    }
    const auto loud = std::ranges::find_if(counts, [&](int count) { return count > limit; });
    ASSERT_NE(loud, counts.end());
    EXPECT_NEAR(result.first_loud.value(), 1e-3 * static_cast<double>(loud - counts.begin() + 1),
                1e-9);
    const std::vector<int> wrong = misclassified_by_splits(counts, limit);
    EXPECT_EQ(wrong.at(static_cast<std::size_t>(result.threshold.value() / 1e-3)),
              std::ranges::min(wrong));
  }
}

constexpr double lowest = 0.1, highest = 18;  // [rad/s]

/// Every `step`-th speed from one on [rad/s] must have the count of its piece.
void expect_counts(const Scene& scene, const CompleteScan& scan, double from, double step,
                   int speeds) {
  std::vector<double> at;
  for (int k = 0; k < speeds; ++k) at.push_back(std::min(from + step * k, highest));
  const std::vector<int> counts = counts_at(scene, at);
  for (std::size_t k = 0; k < at.size(); ++k) {
    const auto piece = std::ranges::lower_bound(scan.pieces, at[k], {}, &CountPiece::to);
    ASSERT_NE(piece, scan.pieces.end());
    if (at[k] < piece->from) continue;  // between two pieces
    ASSERT_EQ(counts[k], piece->count) << at[k] << " rad/s";
  }
}

/// Looks at all speeds 1e-3 rad/s apart, and those 1e-6 rad/s apart near every step and at random.
void expect_complete(const Scene& scene, const CompleteScan& scan, RandomScenes& random) {
  ASSERT_FALSE(scan.pieces.empty());
  EXPECT_EQ(scan.pieces.front().from, lowest);
  EXPECT_EQ(scan.pieces.back().to, highest);
  for (std::size_t k = 1; k < scan.pieces.size(); ++k) {
    const auto &before = scan.pieces[k - 1], &piece = scan.pieces[k];
    EXPECT_NE(piece.count, before.count);
    EXPECT_GT(piece.from, before.to);
    EXPECT_LE(piece.from - before.to, CompleteScanOptions().resolution);
  }
  expect_counts(scene, scan, lowest, 1e-3, 17'900);
  for (const CountPiece& piece : scan.pieces) {
    if (piece.from > 2 * lowest) expect_counts(scene, scan, piece.from - 2e-4, 1e-6, 400);
  }
  for (int i = 0; i < 10; ++i) {
    expect_counts(scene, scan, random.within(lowest, highest - 1e-3), 1e-6, 500);
  }
}

TEST(CompleteScan, HoldsAtEverySpeedLookedAt) {
  RandomScenes random(77);
  for (const char* id : {"C1", "C4", "C5", "C9", "C12"}) {
    SCOPED_TRACE(id);
    const auto scan = scan_completely(case_scene(id), lowest, highest);
    ASSERT_TRUE(scan);
    EXPECT_LT(scan->simulations, 2500);
    expect_complete(case_scene(id), *scan, random);
  }
  int complete = 0;
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const Scene scene = random.next();
    const auto scan = scan_completely(scene, lowest, highest, {.most = 2000});
    complete += scan.has_value();
    if (scan) expect_complete(scene, *scan, random);
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
  const CompleteScan scan = scan_completely(scene, 8.2, 8.3).value();
  EXPECT_EQ(std::ranges::count_if(
                scan.pieces, [](const auto& p) { return p.to - p.from < 1e-3 && p.from > 8.2; }),
            2);
}

TEST(CompleteScan, FindsTheFirstSpeedAboveALimit) {
  const Scene scene = case_scene("C1");
  const CompleteScan scan = scan_completely(scene, lowest, highest).value();
  const double first = scan.first_above(7.5).value().from;
  EXPECT_GT(count_at(scene, first), 7.5);
  EXPECT_LE(count_at(scene, first - 1e-6), 7.5);
  EXPECT_FALSE(scan.first_above(1e6));
}

TEST(CompleteScan, GivesUpWhereItIsNoCheaperAndRefusesOtherRules) {
  EXPECT_FALSE(scan_completely(case_scene("C2"), lowest, highest, {.most = 10}));
  const Scene peaks = with(case_scene("C1"), set::rule(CountRule::peaks));
  EXPECT_THROW(scan_completely(peaks, lowest, highest), std::invalid_argument);
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
    const int most = count_at(scene, random.within(from, to));
    const std::vector<CoordinateRange> ranges = not_excluded(scene, from, to, most);
    std::vector<double> speeds;
    for (double w = from; w <= to; w += 1e-3) speeds.push_back(w);
    const std::vector<int> counts = counts_at(scene, speeds);
    for (std::size_t k = 0; k < speeds.size(); ++k) {
      if (counts[k] > most) continue;
      ++held;
      // Speeds between two pieces of a scan are known to its resolution only.
      EXPECT_TRUE(std::ranges::any_of(ranges, [&](const CoordinateRange& range) {
        return speeds[k] >= range.from - 2e-6 && speeds[k] <= range.to + 2e-6;
      })) << speeds[k];
    }
    excluded += to - from;
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      excluded -= ranges[k].to - ranges[k].from;
      EXPECT_LE(ranges[k].from, ranges[k].to);
      EXPECT_TRUE(k == 0 || ranges[k].from > ranges[k - 1].to) << k;
    }
  }
  EXPECT_GT(held, 1000);
  EXPECT_GT(excluded, 1);
}

}  // namespace
}  // namespace ricochet::carrier_track
