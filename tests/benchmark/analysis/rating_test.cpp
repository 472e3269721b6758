#include "src/benchmark/analysis/rating.h"

#include <gtest/gtest.h>

#include "tests/benchmark/analysis/held_campaign.h"

namespace ricochet::comparison {
namespace {

TEST(Rating, TakesWholeLevelsForTheTargetsOfACount) {
  Problem problem = valley_problem();
  problem.tolerance = 0.5;
  EXPECT_EQ(targets_of(problem), (std::vector<double>{0.5, 1.5, 2.5, 4.5, 8.5}));
  problem.tolerance = 0.01;
  EXPECT_EQ(targets_of(problem).size(), 4U);
  EXPECT_DOUBLE_EQ(targets_of(problem).back(), 10);
}

class RatedCampaign : public HeldCampaign {
 protected:
  /// Of these solvers, that are shown what is judged.
  std::vector<Rating> rated(const std::vector<Solver>& solvers, const std::string& budget,
                            int instances) {
    hold(solvers, budget, instances, {}, "\"count\"");
    return rate(comparison_of(*campaign_, cell_results(*campaign_, *store_), {}), {0}, 0);
  }
};

TEST_F(RatedCampaign, PutsTheQuickBeforeTheSlowAndTheSlowBeforeTheHopeless) {
  const auto ratings =
      rated({patient("hopeless", 1000), patient("slow", 20), patient("quick", 3)}, "50", 6);
  ASSERT_EQ(ratings.size(), 3U);
  EXPECT_EQ(ratings[0].solver, "quick");
  EXPECT_EQ(ratings[1].solver, "slow");
  EXPECT_EQ(ratings[2].solver, "hopeless");
  EXPECT_EQ(ratings[0].rank, 1);
  EXPECT_EQ(ratings[2].rank, 3);
  EXPECT_EQ(ratings[0].never, 0);
  EXPECT_EQ(ratings[2].never, 1);
  EXPECT_GT(ratings[0].probability_of_being_best, 0.8);
  EXPECT_LT(ratings[2].probability_of_being_best, 0.1);
  EXPECT_EQ(ratings[0].progress.front().share, 0);
  EXPECT_EQ(ratings[0].progress.back().share, 1);
  EXPECT_EQ(ratings[2].progress.back().share, 0);
}

TEST_F(RatedCampaign, GivesEqualsTheSameChance) {
  for (const Rating& rating : rated({patient("a", 3), patient("b", 3)}, "20", 10)) {
    EXPECT_NEAR(rating.probability_of_being_best, 0.5, 0.05);
    EXPECT_EQ(rating.rank, 1.5);
  }
}

}  // namespace
}  // namespace ricochet::comparison
