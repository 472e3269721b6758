#include <gtest/gtest.h>

#include "src/studies/impact_test/score.h"
#include "src/studies/impact_test/simulator.h"

namespace ricochet::studies::impact_test {
namespace {

TEST(OwnLevel, HardWallsLoseNothing) {
  for (int k = 0; k < 88; ++k) {
    const ScoredScene scored = drawn_scene(7, k);
    for (const std::size_t level : {0, 2}) {
      const Score score = score_of(own_levels()[level].answer(scored, Level::usual), scored);
      EXPECT_EQ(score.ending, Ending::answered);
      EXPECT_EQ(score.wrong() + score.late + score.wrong_speed, 0)
          << own_levels()[level].tool.name << ", " << scored.scene.scene;
      EXPECT_LT(score.time_error.value_or(0), 1e-7);
    }
  }
}

TEST(OwnLevel, CompliantWallsComeNearerAsTheyBecomeStiffer) {
  const OwnLevel& compliant = own_levels()[3];
  ASSERT_EQ(compliant.tool.name, "exact-restitution");
  int loose = 0, tight = 0;
  double deepest = 0;
  for (int k = 0; k < 44; ++k) {
    const ScoredScene scored = drawn_scene(7, k);
    loose += score_of(compliant.answer(scored, Level::loose), scored).wrong();
    const Answer answer = compliant.answer(scored, Level::tight);
    tight += score_of(answer, scored).wrong();
    deepest = std::max(deepest, answer.deepest);
  }
  EXPECT_LT(tight, loose / 3);
  EXPECT_GT(deepest, 0);
  EXPECT_LT(deepest, 1e-5);
}

TEST(OwnLevel, AScanHasTheImpactsOfItsScene) {
  const ScoredScene scored = drawn_scene(7, 0);
  const OwnLevel& scan = own_levels()[1];
  EXPECT_EQ(score_of(scan.answer(scored, Level::usual), scored).wrong(), 0);
  const ScoredScene with_profile = drawn_scene(7, 10);
  EXPECT_EQ(scan.answer(with_profile, Level::usual).ending, Ending::cannot);
}

TEST(OwnLevel, SaysWhatItCannotDo) {
  ScoredScene plastic = drawn_scene(7, 9);
  plastic.machine.restitution_lower = plastic.machine.restitution_upper = 0;
  EXPECT_EQ(own_levels()[3].answer(plastic, Level::usual).ending, Ending::cannot);
}

}  // namespace
}  // namespace ricochet::studies::impact_test
