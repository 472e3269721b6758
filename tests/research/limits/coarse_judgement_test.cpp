#include "src/research/limits/coarse_judgement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "src/research/calibration/appraisal.h"
#include "tests/research/limits/usual_fit.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

/// What the paper claims, word for word.
CoarseJudgement claimed_judgement() {
  CoarseJudgement judgement{{}, 0};
  for (const Case& c : all_cases()) {
    if (!c.claim.threshold) continue;
    judgement.cases.push_back({c, {*c.claim.quiet_count, 1, *c.claim.threshold, 0, 2, 0, 0}});
  }
  return judgement;
}

TEST(GoalValues, AreZeroOfTheClaimsThemselves) {
  const GoalValues goals = goals_of(claimed_judgement());
  EXPECT_EQ(goals.threshold_error, 0);
  EXPECT_EQ(goals.worst_threshold, 0);
  EXPECT_EQ(goals.counts_missed, 0);
  EXPECT_EQ(goals.count_distance, 0);
  EXPECT_EQ(goals.impurity, 0);
  EXPECT_EQ(goals.examples_missed, 0);
}

TEST(GoalValues, CountWhatIsMissed) {
  CoarseJudgement judgement = claimed_judgement();
  judgement.cases[0].score.threshold *= std::exp(-0.1);
  judgement.cases[1].score.threshold *= std::exp(0.2);
  judgement.cases[2].score.quiet_count = 6;
  judgement.cases[3].score.purity = 0.25;
  judgement.cases[4].score.wrong_examples = 2;
  const GoalValues goals = goals_of(judgement);
  EXPECT_NEAR(goals.threshold_error, std::sqrt((0.01 + 0.04) / 10), 1e-12);
  EXPECT_NEAR(goals.worst_threshold, 0.2, 1e-12);
  EXPECT_EQ(goals.counts_missed, 1);
  EXPECT_NEAR(goals.count_distance, std::log(6.3 / 5.3) / 10, 1e-12);
  EXPECT_EQ(goals.impurity, 0.75);
  EXPECT_EQ(goals.examples_missed, 2);
}

TEST(CoarseJudgement, TellsErrorsOfAPercentApart) {
  const Fit fit = usual_fit();
  const GoalValues goals = goals_of(judged_coarsely(fit.interpretation, fit.constants));
  const calibration::Appraisal fine = calibration::appraise(fit, 0.01);
  EXPECT_NEAR(goals.threshold_error, fine.threshold_error, 0.005);
  EXPECT_NEAR(goals.worst_threshold, fine.worst_threshold, 0.01);
  EXPECT_NEAR(1 - goals.impurity, fine.purity, 0.1);
}

TEST(CoarseJudgement, OfThresholdsIsTheSameButForC11) {
  const Fit fit = usual_fit();
  const CoarseJudgement all = judged_coarsely(fit.interpretation, fit.constants);
  const CoarseJudgement some = judged_by_thresholds(fit.interpretation, fit.constants);
  ASSERT_EQ(all.cases.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(all.cases[i].score.threshold, some.cases[i].score.threshold);
  }
  EXPECT_GT(all.quiet_share, 0);
  EXPECT_EQ(some.quiet_share, 0);
}

}  // namespace
}  // namespace ricochet::studies::limits
