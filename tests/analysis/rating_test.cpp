#include "src/analysis/rating.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/analysis/held_campaign.h"

namespace ricochet::comparison {
namespace {

/// Returns the best point after so many evaluations, and one.
Solver honest(const std::string& name, int wasted) {
  return patient(name, wasted, false, true);
}

/// Evaluates the best point and returns another.
Solver careless(const std::string& name, int wasted) {
  return patient(name, wasted);
}

class RatedCampaign : public HeldCampaign {
 protected:
  /// Of these solvers on three valleys, that see the true objective.
  Comparison compared(const std::vector<Solver>& solvers, const std::string& budget = "50",
                      int instances = 4) {
    Catalogue catalogue;
    for (const char* name : {"valley-a", "valley-b", "valley-c"}) {
      Problem problem = valley_problem();
      problem.name = name;
      problems_.push_back(std::move(problem));
    }
    catalogue.families = {{"valley", problems_}};
    catalogue.solvers = solvers;
    campaign_.emplace(
        plan_from(fmt::format("[[part]]\nproblems = \"*\"\nsolvers = \"*\"\nbudgets = {}\n"
                              "instances = {}\nformulations = \"count\"\n",
                              budget, instances),
                  "test"),
        catalogue);
    store_.emplace(Store::create(folder_ / "runs.sqlite", campaign_->description()));
    make_runs(*campaign_, {}, *store_);
    return comparison_of(*campaign_, cell_results(*campaign_, *store_), {});
  }

  std::vector<Problem> problems_;
  const std::vector<std::size_t> all_ = {0, 1, 2};
};

TEST_F(RatedCampaign, PutsTheQuickBeforeTheSlowAndTheSlowBeforeTheHopeless) {
  const auto ratings =
      rate(compared({honest("hopeless", 1000), honest("slow", 20), honest("quick", 3)}), all_, 0);
  ASSERT_EQ(ratings.size(), 3U);
  EXPECT_EQ(ratings[0].solver, "quick");
  EXPECT_EQ(ratings[1].solver, "slow");
  EXPECT_EQ(ratings[2].solver, "hopeless");
  EXPECT_EQ(ratings[0].rank, 1);
  EXPECT_EQ(ratings[2].rank, 3);
  EXPECT_EQ(ratings[0].never, 0);
  EXPECT_EQ(ratings[2].never, 3);
  EXPECT_EQ(ratings[0].problems, 3);
  EXPECT_EQ(ratings[0].probability_of_being_best, 1);
  EXPECT_EQ(ratings[2].probability_of_being_best, 0);
  EXPECT_LT(ratings[0].progress.front().share, 1);
  EXPECT_EQ(ratings[0].progress.back().share, 1);
  EXPECT_LT(ratings[2].progress.back().share, 0.5);
  EXPECT_EQ(leader_of(ratings)->solver, "quick");
}

TEST_F(RatedCampaign, JudgesByTheReturnedPoint) {
  const Comparison comparison = compared({careless("careless", 3), honest("honest", 20)});
  const auto by_returned = rate(comparison, all_, 0);
  EXPECT_EQ(by_returned[0].solver, "honest");
  EXPECT_EQ(by_returned[0].returned, 1);
  EXPECT_EQ(by_returned[1].returned, 0);
  EXPECT_EQ(by_returned[1].found, 1) << "it evaluated the best point";
  EXPECT_LT(by_returned[1].progress.back().share, 0.5) << "which a user would not get";
  EXPECT_EQ(by_returned[1].never, 3);
}

TEST_F(RatedCampaign, HasNoLeaderIfNobodySolvedARun) {
  const Comparison comparison = compared({careless("a", 3), careless("b", 5)});
  const auto ratings = rate(comparison, all_, 0);
  EXPECT_EQ(leader_of(ratings), nullptr);
  EXPECT_FALSE(ratings[0].probability_of_being_best);
  EXPECT_EQ(leader_of({}), nullptr);
}

TEST(Leader, IsNotOneThatSolvedNothing) {
  Rating near;
  near.rank = 1;
  Rating solving;
  solving.rank = 2;
  solving.returned = 0.1;
  EXPECT_EQ(leader_of({near, solving}), nullptr);
  near.returned = 0.1;
  EXPECT_NE(leader_of({near, solving}), nullptr);
  near.rank.reset();
  EXPECT_EQ(leader_of({near}), nullptr) << "it takes few problems";
}

TEST_F(RatedCampaign, HasNoProbabilityForOneProblem) {
  const Comparison comparison = compared({honest("a", 3), honest("b", 5)});
  for (const Rating& rating : rate(comparison, {1}, 0)) {
    EXPECT_FALSE(rating.probability_of_being_best);
    EXPECT_TRUE(rating.rank);
  }
  EXPECT_EQ(leader_of(rate(comparison, {1}, 0))->solver, "a");
}

TEST_F(RatedCampaign, RanksThoseWhoTakeHalfOfTheProblemsOnly) {
  Comparison comparison = compared({honest("all", 5), honest("most", 7), honest("one", 1)});
  std::erase_if(comparison.results, [](const CellResult& result) {
    const std::size_t q = result.cell->problem;
    const std::string& solver = result.cell->cell.solver;
    return (solver == "most" && q == 0) || (solver == "one" && q != 2);
  });
  const auto ratings = rate(comparison, all_, 0);
  ASSERT_EQ(ratings.size(), 3U);
  EXPECT_EQ(ratings[0].solver, "all");
  EXPECT_EQ(ratings[1].solver, "most");
  EXPECT_EQ(ratings[1].problems, 2);
  EXPECT_EQ(ratings[1].rank, 2);
  EXPECT_EQ(ratings[2].solver, "one") << "the quickest, but on one of three problems";
  EXPECT_FALSE(ratings[2].rank);
  EXPECT_FALSE(ratings[2].probability_of_being_best);
  EXPECT_EQ(ratings[2].problems, 1);
  const RankedEntries ranked = ranked_entries(comparison, all_, 0);
  EXPECT_EQ(ranked.names, (std::vector<std::string>{"all, count", "most, count"}));
  EXPECT_EQ(ranked.problems.size(), 2U) << "one of them takes the first problem alone";
}

TEST_F(RatedCampaign, GivesEqualsTheSameChance) {
  for (const Rating& rating : rate(compared({honest("a", 3), honest("b", 3)}, "20"), all_, 0)) {
    EXPECT_NEAR(*rating.probability_of_being_best, 0.5, 1e-9);
    EXPECT_EQ(rating.rank, 1.5);
  }
}

TEST_F(RatedCampaign, CountsEveryTargetOfEveryRunOverTime) {
  const Comparison comparison = compared({honest("quick", 3)});
  const Rating rating = rate(comparison, all_, 0)[0];
  EXPECT_EQ(rating.progress.back().evaluations, 50) << "the budget, which is no power of 10";
  for (const Reach& reach : rating.progress) {
    double share = 0;
    for (const CellResult& result : comparison.results) {
      for (const Outcome& outcome : result.outcomes) {
        double best = std::numeric_limits<double>::infinity();
        for (const Step& step : outcome.steps) {
          if (static_cast<double>(step.evaluations) <= reach.evaluations)
            best = step.optimality_gap;
        }
        share += static_cast<double>(std::ranges::count_if(
                     *result.targets, [&](double target) { return best <= target; })) /
                 static_cast<double>(result.targets->size()) / (3.0 * 4);
      }
    }
    EXPECT_NEAR(reach.share, share, 1e-12) << reach.evaluations;
  }
}

}  // namespace
}  // namespace ricochet::comparison
