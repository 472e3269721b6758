#include "src/research/limits/claims.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/research/limits/usual_fit.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

CoarseJudgement usual_judgement() {
  return judged_coarsely(usual_fit().interpretation, usual_fit().constants);
}

TEST(Claims, AddUpToTheLossButForItsShapes) {
  const CoarseJudgement judgement = usual_judgement();
  double shapes = 0, whole = 4 * judgement.quiet_share;
  for (const CoarseCase& c : judgement.cases) {
    shapes += 3 * c.score.shape;
    whole += loss_of(c.score, c.the_case.claim);
  }
  EXPECT_NEAR(loss_without(judgement, {}), whole - shapes, 1e-9);
}

TEST(Claims, AreSixOfACaseAndOneOfC11) {
  EXPECT_EQ(all_claims().size(), 61U);
  std::set<std::string> names;
  for (const Claimed& claim : all_claims()) names.insert(claim.name());
  EXPECT_EQ(names.size(), 61U);
  EXPECT_TRUE(names.contains("C3's quiet count"));
  EXPECT_TRUE(names.contains("C11 is never quiet"));
  EXPECT_EQ(dropped_groups().size(), 32U);
  EXPECT_EQ(dropped_groups().back().claims.size(), 10U);
}

TEST(Claims, AreAskedForOrNot) {
  const CoarseJudgement judgement = usual_judgement();
  const double all = loss_without(judgement, {});
  for (const auto& groups : {dropped_groups(), asked_groups()}) {
    for (const ClaimGroup& group : groups) {
      EXPECT_NEAR(loss_of_only(judgement, group) + loss_without(judgement, group), all, 1e-9)
          << group.name;
    }
  }
  EXPECT_NEAR(loss_of_only(judgement, asked_groups().back()), all, 1e-9);
}

}  // namespace
}  // namespace ricochet::studies::limits
