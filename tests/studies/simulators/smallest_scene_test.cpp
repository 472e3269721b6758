#include <gmock/gmock.h>

#include "src/studies/simulators/suite.h"

namespace ricochet::studies::simulators {
namespace {

/// A tool that has the true impacts, but none that is slower than 30 % of the fastest.
bool breaks_who_sees_fast_ones_alone(const ScoredScene& scored) {
  double fastest = 0;
  for (const TrueImpact& i : scored.truth) fastest = std::max(fastest, i.speed);
  Answer answer{scored.scene.scene};
  for (const TrueImpact& i : scored.truth) {
    if (i.speed > 0.3 * fastest) answer.impacts.push_back({i.time, i.wall, i.speed});
  }
  return score_of(answer, scored).wrong() > 0;
}

TEST(SmallestScene, IsSmallerAndStillBreaks) {
  for (const int index : {0, 1, 10}) {
    const ScoredScene from = drawn_scene(2, index);
    ASSERT_TRUE(breaks_who_sees_fast_ones_alone(from));
    int asked = 0;
    const ScoredScene smallest = smallest_scene(
        from,
        [&](const ScoredScene& scored) {
          ++asked;
          return breaks_who_sees_fast_ones_alone(scored);
        },
        200);
    EXPECT_LE(asked, 200);
    EXPECT_TRUE(breaks_who_sees_fast_ones_alone(smallest));
    EXPECT_LE(scored_impacts(smallest.scene, smallest.truth), 7) << words_of(smallest.machine);
    EXPECT_LT(words_of(smallest.machine).size(), words_of(from.machine).size());
    EXPECT_EQ(smallest.machine.mass, 1);
    // It is a scene like any other: ricochet has its impacts.
    const Score score = score_of(own_simulators()[0].open(Level::usual)(smallest), smallest);
    EXPECT_EQ(score.wrong() + score.late, 0);
  }
}

TEST(SmallestScene, IsTheSameSceneIfNoOtherBreaks) {
  const ScoredScene from = drawn_scene(2, 3);
  const ScoredScene same = smallest_scene(
      from, [](const ScoredScene&) { return false; }, 200);
  EXPECT_EQ(json_of(same).dump(), json_of(from).dump());
}

TEST(SmallestScene, IsDescribedInWords) {
  Scene machine;
  machine.pull = 2;
  machine.restitution_lower = machine.restitution_upper = 0.5;
  EXPECT_EQ(words_of(machine),
            "1 kg, walls at 0 and 1 m, restitution 0.5, pull 2 N, from 0.5 m with 0 m/s, 1 s");
}

TEST(SmallestScene, IsNoSceneThatEndsAtAnImpact) {
  Scene machine;  // falls 0.5 m in 1 s
  machine.pull = 1;
  machine.restitution_lower = 0.5;
  machine.window = carrier_track::Seconds{1.001};
  EXPECT_FALSE(exactly(machine));
  machine.window = carrier_track::Seconds{1.5};
  ASSERT_TRUE(exactly(machine));
  EXPECT_EQ(exactly(machine)->truth.size(), 1U);
  machine.mass = -1;
  EXPECT_FALSE(exactly(machine));
}

}  // namespace
}  // namespace ricochet::studies::simulators
