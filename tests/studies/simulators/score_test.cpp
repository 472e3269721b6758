#include <gmock/gmock.h>

#include "tests/studies/simulators/some_scenes.h"

namespace ricochet::studies::simulators {
namespace {

using testing::ElementsAre;
using testing::Optional;
using Place = std::size_t;

constexpr auto nobody = std::nullopt;

std::vector<Impact> on_lower(const std::vector<double>& times) {
  std::vector<Impact> impacts;
  for (const double t : times) impacts.push_back({t, Wall::lower, 1});
  return impacts;
}

TEST(Match, MakesAsManyPairsAsPossible) {
  // Greedily the first true one would take the second found one, and the last would have none.
  EXPECT_THAT(partners_of(on_lower({1.0, 1.5}), on_lower({0.6, 1.1}), 0.5),
              ElementsAre(Optional(Place{0}), Optional(Place{1})));
}

TEST(Match, TakesTheNearestAmongAsManyPairs) {
  EXPECT_THAT(partners_of(on_lower({1}), on_lower({0.9, 1.01, 1.2}), 0.5),
              ElementsAre(Optional(Place{1})));
}

TEST(Match, FindsTheOneThatIsMissing) {
  EXPECT_THAT(partners_of(on_lower({1, 2, 3, 4}), on_lower({1.1, 3.1, 4.1}), 0.5),
              ElementsAre(Optional(Place{0}), nobody, Optional(Place{1}), Optional(Place{2})));
}

TEST(Match, PairsNobodyTooFarAwayOrOnTheOtherWall) {
  const std::vector<Impact> found = {{1, Wall::upper, 1}, {1.6, Wall::lower, 1}};
  EXPECT_THAT(partners_of(on_lower({1}), found, 0.5), ElementsAre(nobody));
  EXPECT_THAT(partners_of(on_lower({1}), {}, 0.5), ElementsAre(nobody));
}

TEST(Score, OfARightAnswerHasNoFault) {
  const ScoredScene scored = with_impacts(9);
  const Score score = score_of(right_answer(scored), scored);
  EXPECT_EQ(score.impacts, 9);
  EXPECT_EQ(score.wrong() + score.late + score.wrong_speed, 0);
  EXPECT_EQ(score.time_error, 0);
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

TEST(Tally, AddsUpScores) {
  const ScoredScene nine = with_impacts(9), two = with_impacts(2);
  Answer lossy = right_answer(nine);
  lossy.impacts.pop_back();
  const Tally all = tally_of({score_of(lossy, nine), score_of({"made", Ending::cannot, ""}, nine),
                              score_of({"made", Ending::never, ""}, two)});
  EXPECT_EQ(all.scenes, 3);
  EXPECT_EQ(all.answered, 1);
  EXPECT_EQ(all.cannot, 1);
  EXPECT_EQ(all.never, 1);
  EXPECT_EQ(all.impacts, 11) << "without those of the scene that the tool cannot express";
  EXPECT_EQ(all.missed, 3);
  EXPECT_DOUBLE_EQ(*all.wrong(), 3000.0 / 11);
  EXPECT_FALSE(tally_of({}).wrong());
  EXPECT_EQ(median_of({3, 1, 2}), 2);
}

}  // namespace
}  // namespace ricochet::studies::simulators
