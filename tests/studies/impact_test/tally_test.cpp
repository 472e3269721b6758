#include <gtest/gtest.h>

#include "src/studies/impact_test/score.h"
#include "tests/studies/impact_test/some_scenes.h"

namespace ricochet::studies::impact_test {
namespace {

TEST(Tally, AddsUpTheScoresOfChosenScenes) {
  std::vector<ScoredScene> scenes = {with_impacts(9), with_impacts(9), with_impacts(2)};
  scenes[2].scene.difficulty = 3;
  Answer lossy = right_answer(scenes[0]);
  lossy.impacts.pop_back();
  const std::vector<Score> scores = {score_of(lossy, scenes[0]),
                                     score_of({"made", Ending::cannot, ""}, scenes[1]),
                                     score_of({"made", Ending::never, ""}, scenes[2])};
  const Tally all = tally_of(scores, scenes, [](const TestScene&) { return true; });
  EXPECT_EQ(all.scenes, 3);
  EXPECT_EQ(all.answered, 1);
  EXPECT_EQ(all.cannot, 1);
  EXPECT_EQ(all.never, 1);
  EXPECT_EQ(all.impacts, 11) << "without those of the scene that the tool cannot express";
  EXPECT_EQ(all.missed, 3);
  EXPECT_DOUBLE_EQ(*all.per_thousand(all.missed), 3000.0 / 11);
  const Tally hard = tally_of(scores, scenes, [](const TestScene& s) { return s.difficulty == 3; });
  EXPECT_EQ(hard.impacts, 2);
  EXPECT_FALSE(hard.time_error);
}

TEST(Tally, ComparesTimesSceneByScene) {
  std::vector<Score> fast(3), slow(3);
  for (const int k : {0, 1, 2}) {
    fast[static_cast<std::size_t>(k)].seconds_per_impact = k + 1;
    slow[static_cast<std::size_t>(k)].seconds_per_impact = 10.0 * (k + 1);
  }
  slow[0].seconds_per_impact.reset();
  EXPECT_EQ(time_ratio(slow, fast), 10);
  EXPECT_FALSE(time_ratio({}, fast));
  EXPECT_EQ(median_of({3, 1, 2}), 2);
}

}  // namespace
}  // namespace ricochet::studies::impact_test
