#include "src/analysis/rating.h"

#include "tests/analysis/held_campaign.h"
#include "tests/support/test.h"

namespace ricochet::comparison {
namespace {

using testing::ElementsAre;
using testing::Pair;

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
  Comparison compared(const std::vector<Solver>& solvers, int budget = 50) {
    std::vector<Problem> problems;
    for (const char* name : {"valley-a", "valley-b", "valley-c"}) {
      problems.push_back(valley_problem());
      problems.back().name = name;
    }
    hold(solvers, {fmt::format("budgets = {}\ninstances = 4\nformulations = \"count\"\n", budget)},
         {}, problems);
    return comparison_of(*campaign_, results(), {});
  }

  const std::vector<std::size_t> all_ = {0, 1, 2};
};

/// The solvers with their ranks; 0: none.
std::vector<std::pair<std::string, double>> ranks_in(const std::vector<Rating>& ratings) {
  std::vector<std::pair<std::string, double>> ranks;
  for (const Rating& rating : ratings) ranks.emplace_back(rating.solver, rating.rank.value_or(0));
  return ranks;
}

TEST_F(RatedCampaign, PutsTheQuickBeforeTheSlowAndTheSlowBeforeTheHopeless) {
  const auto ratings =
      rate(compared({honest("hopeless", 1000), honest("slow", 20), honest("quick", 3)}), all_, 0);
  ASSERT_THAT(ranks_in(ratings),
              ElementsAre(Pair("quick", 1), Pair("slow", 2), Pair("hopeless", 3)));
  const Rating& quick = ratings[0];
  const Rating& hopeless = ratings[2];
  EXPECT_EQ(quick.never, 0);
  EXPECT_EQ(hopeless.never, 3);
  EXPECT_EQ(quick.problems, 3);
  EXPECT_EQ(quick.probability_of_being_best, 1);
  EXPECT_EQ(hopeless.probability_of_being_best, 0);
  EXPECT_LT(quick.progress.front().share, 1);
  EXPECT_EQ(quick.progress.back().share, 1);
  EXPECT_LT(hopeless.progress.back().share, 0.5);
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

TEST(Leader, IsNotOneThatSolvedNothing) {
  Rating near;
  near.rank = 1;
  Rating solving;
  solving.rank = 2;
  solving.returned = 0.1;
  EXPECT_EQ(leader_of({}), nullptr);
  EXPECT_EQ(leader_of({near, solving}), nullptr);
  near.returned = 0.1;
  EXPECT_NE(leader_of({near, solving}), nullptr);
  near.rank.reset();
  EXPECT_EQ(leader_of({near}), nullptr) << "it takes few problems";
}

TEST_F(RatedCampaign, HasNoProbabilityForOneProblemOrIfNobodySolvedARun) {
  const auto of_one = rate(compared({honest("a", 3), honest("b", 5)}), {1}, 0);
  for (const Rating& rating : of_one) {
    EXPECT_FALSE(rating.probability_of_being_best);
    EXPECT_TRUE(rating.rank);
  }
  EXPECT_EQ(leader_of(of_one)->solver, "a");
  std::filesystem::remove(folder_ / "runs.sqlite");
  const auto of_none = rate(compared({careless("a", 3), careless("b", 5)}), all_, 0);
  EXPECT_EQ(leader_of(of_none), nullptr);
  EXPECT_FALSE(of_none[0].probability_of_being_best);
}

TEST_F(RatedCampaign, RanksThoseWhoTakeHalfOfTheProblemsOnly) {
  Comparison comparison = compared({honest("all", 5), honest("most", 7), honest("one", 1)});
  std::erase_if(comparison.results, [](const CellResult& result) {
    const std::size_t q = result.cell->problem;
    const std::string& solver = result.cell->cell.solver;
    return (solver == "most" && q == 0) || (solver == "one" && q != 2);
  });
  const auto ratings = rate(comparison, all_, 0);
  ASSERT_THAT(ranks_in(ratings), ElementsAre(Pair("all", 1), Pair("most", 2), Pair("one", 0)))
      << "it is the quickest, but on one of three problems";
  EXPECT_EQ(ratings[1].problems, 2);
  EXPECT_EQ(ratings[2].problems, 1);
  EXPECT_FALSE(ratings[2].probability_of_being_best);
  const RankedEntries ranked = ranked_entries(comparison, all_, 0);
  EXPECT_EQ(ranked.names, (std::vector<std::string>{"all, count", "most, count"}));
  EXPECT_EQ(ranked.problems.size(), 2U) << "one of them takes the first problem alone";
}

TEST_F(RatedCampaign, GivesEqualsTheSameChance) {
  for (const Rating& rating : rate(compared({honest("a", 3), honest("b", 3)}, 20), all_, 0)) {
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

TEST(StratifiedSample, HasOneItemOfEachStratum) {
  // Values 0 to 11 in a mixed order; three strata of four.
  const std::vector<double> values = {5, 0, 11, 3, 8, 1, 10, 2, 9, 4, 7, 6};
  std::set<std::size_t> all;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto drawn = stratified_sample(values, 3, seed);
    ASSERT_EQ(drawn.size(), 3U);
    for (std::size_t stratum = 0; stratum < 3; ++stratum) {
      EXPECT_GE(values[drawn[stratum]], 4.0 * static_cast<double>(stratum));
      EXPECT_LT(values[drawn[stratum]], 4.0 * static_cast<double>(stratum) + 4);
    }
    all.insert(drawn.begin(), drawn.end());
  }
  EXPECT_EQ(all.size(), values.size()) << "any may be drawn";
}

TEST(StratifiedSample, IsAllIfThereAreNoMore) {
  EXPECT_THAT(stratified_sample({2, 1, 2}, 3, 0), ElementsAre(1, 0, 2));
  EXPECT_THAT(stratified_sample({2, 1}, 5, 0), ElementsAre(1, 0));
  EXPECT_TRUE(stratified_sample({}, 3, 0).empty());
}

}  // namespace
}  // namespace ricochet::comparison
