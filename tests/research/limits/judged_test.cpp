#include "src/research/limits/judged.h"

#include <gtest/gtest.h>

#include "tests/research/limits/usual_fit.h"

namespace ricochet::studies::limits {
namespace {

TEST(Judged, IsWhatTheAppraisalSays) {
  const auto all = judged({usual_fit()}, 0.05);
  ASSERT_EQ(all.size(), 1U);
  const calibration::Appraisal fine = calibration::appraise(usual_fit(), 0.05);
  EXPECT_EQ(all[0].fine.threshold_error, fine.threshold_error);
  EXPECT_EQ(all[0].counts_missed(), 10 - fine.exact_counts);
  EXPECT_EQ(all[0].examples_missed(), 20 - fine.right_examples);
  EXPECT_TRUE(all[0].fine.cases.empty());
  const CoarseDoubt doubt = doubt_of(all);
  EXPECT_EQ(doubt.points, 1);
  EXPECT_EQ(doubt.largest_error, std::abs(all[0].coarse.threshold_error - fine.threshold_error));
  EXPECT_EQ(doubt.median_error, doubt.largest_error);
}

TEST(WorthJudging, IsWhatNothingElseIsAsGoodAs) {
  const auto with_error = [](double error) {
    Fit fit = usual_fit();
    fit.loss = error;
    return fit;
  };
  ChainedFront one, other;
  one.goals = {{0.1, 0, 2, 0.3, 0.5, 0},     // kept
               {0.105, 0, 2, 0.1, 0.5, 0},   // worse but for the counts' distance
               {0.05, 0, 2, 0.1, 0.6, 2},    // too many examples missed
               {0.4, 0, 0, 0.1, 0.5, 0}};    // too far off
  other.goals = {{0.11, 0, 2, 0.1, 0.5, 0},  // worse than the first
                 {0.2, 0, 1, 0.1, 0.5, 1}};  // kept
  for (ChainedFront* front : {&one, &other}) {
    for (const GoalValues& goals : front->goals) {
      front->fits.push_back(with_error(goals.threshold_error));
    }
  }
  const auto fits = worth_judging({&one, &other}, {1, 0.25});
  ASSERT_EQ(fits.size(), 2U);
  EXPECT_EQ(fits[0].loss, 0.1);
  EXPECT_EQ(fits[1].loss, 0.2);
}

TEST(BestPairs, FallWhereTheFirstRises) {
  EXPECT_EQ(best_pairs({{3, 1}, {1, 5}, {2, 5}, {2, 2}, {4, 1}}),
            (std::vector<Pair>{{1, 5}, {2, 2}, {3, 1}}));
  EXPECT_TRUE(best_pairs({}).empty());
}

}  // namespace
}  // namespace ricochet::studies::limits
