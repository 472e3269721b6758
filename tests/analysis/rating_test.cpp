#include "src/analysis/rating.h"

#include "tests/analysis/held_campaign.h"

namespace ricochet::comparison {
namespace {

/// Returns the best point after so many evaluations, and one.
Solver honest(const std::string& name, int wasted) {
  return patient(name, wasted, false, true);
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

/// Each solver with its rank, problems, those that it never solved, and P(best); -1: none.
std::vector<std::string> summaries(const std::vector<Rating>& ratings) {
  std::vector<std::string> all;
  for (const Rating& r : ratings) {
    all.push_back(fmt::format("{}: rank {}, of {} problems {} never, P {:.9g}", r.solver,
                              r.rank.value_or(-1), r.problems, r.never,
                              r.probability_of_being_best.value_or(-1)));
  }
  return all;
}

TEST_F(RatedCampaign, PutsTheQuickBeforeTheSlowAndTheSlowBeforeTheHopeless) {
  const auto ratings =
      rate(compared({honest("hopeless", 1000), honest("slow", 20), honest("quick", 3)}), all_, 0);
  ASSERT_THAT(summaries(ratings), ElementsAre("quick: rank 1, of 3 problems 0 never, P 1",
                                              "slow: rank 2, of 3 problems 0 never, P 0",
                                              "hopeless: rank 3, of 3 problems 3 never, P 0"));
  EXPECT_LT(ratings[0].progress.front().share, 1);
  EXPECT_EQ(ratings[0].progress.back().share, 1);
  EXPECT_LT(ratings[2].progress.back().share, 0.5);
  EXPECT_EQ(leader_of(ratings)->solver, "quick");
}

TEST_F(RatedCampaign, JudgesByTheReturnedPoint) {
  const auto ratings = rate(compared({patient("careless", 3), honest("honest", 20)}), all_, 0);
  ASSERT_THAT(summaries(ratings), ElementsAre("honest: rank 1, of 3 problems 0 never, P 1",
                                              "careless: rank 2, of 3 problems 3 never, P 0"));
  EXPECT_EQ(ratings[0].returned, 1);
  EXPECT_EQ(ratings[1].returned, 0);
  EXPECT_EQ(ratings[1].found, 1) << "it evaluated the best point";
  EXPECT_LT(ratings[1].progress.back().share, 0.5) << "which a user would not get";
}

TEST_F(RatedCampaign, HasNoProbabilityForOneProblemOrIfNobodySolvedARun) {
  const auto of_one = rate(compared({honest("a", 3), honest("b", 5)}), {1}, 0);
  EXPECT_THAT(summaries(of_one), ElementsAre("a: rank 1, of 1 problems 0 never, P -1",
                                             "b: rank 2, of 1 problems 0 never, P -1"));
  EXPECT_EQ(leader_of(of_one)->solver, "a");
  fs::remove(folder_ / "runs.sqlite");
  auto of_none = rate(compared({patient("a", 3), patient("b", 5)}), all_, 0);
  EXPECT_THAT(summaries(of_none), ElementsAre("a: rank 1.5, of 3 problems 3 never, P -1",
                                              "b: rank 1.5, of 3 problems 3 never, P -1"));
  EXPECT_EQ(leader_of(of_none), nullptr);
  of_none[1].returned = 0.1;
  EXPECT_EQ(leader_of(of_none), nullptr) << "the first solved nothing";
  EXPECT_EQ(leader_of({}), nullptr);
}

TEST_F(RatedCampaign, RanksThoseWhoTakeHalfOfTheProblemsOnly) {
  Comparison comparison = compared({honest("all", 5), honest("most", 7), honest("one", 1)});
  std::erase_if(comparison.results, [](const CellResult& result) {
    const std::size_t q = result.cell->problem;
    const std::string& solver = result.cell->cell.solver;
    return (solver == "most" && q == 0) || (solver == "one" && q != 2);
  });
  const auto ratings = rate(comparison, all_, 0);
  EXPECT_EQ(leader_of({ratings.back()}), nullptr) << "it is not ranked";
  EXPECT_THAT(summaries(ratings), ElementsAre("all: rank 1, of 3 problems 0 never, P 1",
                                              "most: rank 2, of 2 problems 0 never, P 0",
                                              "one: rank -1, of 1 problems 0 never, P -1"))
      << "it is the quickest, but on one of three problems";
  const RankedEntries ranked = ranked_entries(comparison, all_, 0);
  EXPECT_THAT(ranked.names, ElementsAre("all, count", "most, count"));
  EXPECT_EQ(ranked.problems.size(), 2U) << "one of them takes the first problem alone";
}

TEST_F(RatedCampaign, CountsEveryTargetOfEveryRunOverTime) {
  const Comparison comparison = compared({honest("quick", 3)});
  const Rating rating = rate(comparison, all_, 0)[0];
  EXPECT_EQ(rating.progress.back().evaluations, 50) << "the budget, which is no power of 10";
  for (const Reach& reach : rating.progress) {
    double share = 0;
    for (const CellResult& result : comparison.results) {
      for (const Outcome& outcome : result.outcomes) {
        double best = infinity;
        for (const auto& [evaluations, seconds, gap] : outcome.steps) {
          if (static_cast<double>(evaluations) <= reach.evaluations) best = gap;
        }
        const auto targets = static_cast<double>(result.targets->size());
        for (const double target : *result.targets) share += best <= target ? 1 / targets : 0;
      }
    }
    EXPECT_NEAR(reach.share, share / (3 * 4), 1e-12) << reach.evaluations;
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
  EXPECT_THAT(stratified_sample({2, 1, 2}, 3, 0), ElementsAre(1, 0, 2)) << "there are no more";
  EXPECT_THAT(stratified_sample({2, 1}, 5, 0), ElementsAre(1, 0));
  EXPECT_THAT(stratified_sample({}, 3, 0), IsEmpty());
}

}  // namespace
}  // namespace ricochet::comparison
