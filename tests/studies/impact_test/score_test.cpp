#include "src/studies/impact_test/score.h"

#include <gtest/gtest.h>

#include "tests/studies/impact_test/some_scenes.h"

namespace ricochet::studies::impact_test {
namespace {

TEST(Score, OfARightAnswerHasNoFault) {
  const ScoredScene scored = with_impacts(9);
  const Score score = score_of(right_answer(scored), scored);
  EXPECT_EQ(score.impacts, 9);
  EXPECT_EQ(score.wrong() + score.late + score.wrong_speed, 0);
  EXPECT_EQ(score.time_error, 0);
  EXPECT_EQ(score.energy_gained, 0);
  EXPECT_EQ(score.penetration, 0);
  EXPECT_DOUBLE_EQ(*score.seconds_per_impact, 0.5 / 9);
}

TEST(Score, CountsEveryFaultOnce) {
  const ScoredScene scored = with_impacts(9);  // a second apart
  Answer answer = right_answer(scored);
  auto& impacts = answer.impacts;
  impacts[1].time += 0.02;                      // late
  impacts[2].speed *= 1.02;                     // wrong speed
  impacts[8].wall = Wall::upper;                // missed, and invented
  impacts.erase(impacts.begin() + 6);           // missed
  impacts.push_back({3.5, Wall::upper, 0.2});   // invented
  impacts.push_back({3.6, Wall::upper, 0.09});  // too slow to count
  impacts.push_back({11, Wall::lower, 1});      // behind the end
  std::ranges::stable_sort(impacts, {}, &carrier_track::Impact::time);
  answer.deepest = 1e-6;
  const Score score = score_of(answer, scored);
  EXPECT_EQ(score.missed, 2);
  EXPECT_EQ(score.invented, 2);
  EXPECT_EQ(score.late, 1);
  EXPECT_EQ(score.wrong_speed, 1);
  EXPECT_NEAR(*score.time_error, 0.02, 1e-12) << "up to the first that is lost or invented";
  EXPECT_EQ(score.penetration, 1e-6);
  EXPECT_NEAR(*score.energy_gained, (7 + 1.02 * 1.02 + 0.04) / 9 - 1, 1e-12);
}

TEST(Score, DoesNotCountImpactsNextToTheLimit) {
  ScoredScene scored = with_impacts(4);
  scored.truth[1].speed = 0.101;  // counts
  scored.truth[2].speed = 0.099;  // does not
  Answer answer = right_answer(scored);
  answer.impacts[1].speed = 0.099;
  answer.impacts[2].speed = 0.101;
  const Score score = score_of(answer, scored);
  EXPECT_EQ(score.impacts, 3);
  EXPECT_EQ(score.wrong(), 0);
  answer.impacts.erase(answer.impacts.begin() + 2);
  EXPECT_EQ(score_of(answer, scored).wrong(), 0) << "a slow one is not missed";
  answer.impacts[1].speed = 0.049;
  EXPECT_EQ(score_of(answer, scored).missed, 1) << "one of less than half the limit is no partner";
}

TEST(Score, TakesAllImpactsFromWhoGivesNoAnswer) {
  const ScoredScene scored = with_impacts(5);
  EXPECT_EQ(score_of({"made", Ending::never, "10 s"}, scored).missed, 5);
  EXPECT_EQ(score_of({"made", Ending::error, "crash"}, scored).missed, 5);
  const Score cannot = score_of({"made", Ending::cannot, "one wall"}, scored);
  EXPECT_EQ(cannot.impacts, 0);
  EXPECT_EQ(cannot.missed, 0);
}

}  // namespace
}  // namespace ricochet::studies::impact_test
