#include "src/analysis/results.h"

#include "tests/analysis/held_campaign.h"
#include "tests/support/refusals.h"

namespace ricochet::comparison {
namespace {

using testing::Optional;

/// A run that solved after so many evaluations of 100, or not at all.
Outcome run_of(std::optional<std::int64_t> solved, double optimality_gap) {
  Outcome outcome;
  outcome.evaluations = 100;
  outcome.verdict.solved = solved.has_value();
  outcome.verdict.evaluations_to_solve = solved;
  outcome.verdict.optimality_gap = optimality_gap;
  outcome.steps = {{solved.value_or(50), 0.1, optimality_gap}};
  return outcome;
}

TEST(Result, SumsUpTheRuns) {
  const Result result =
      result_of({run_of(10, 0), run_of(30, 0), run_of({}, 2), run_of({}, 4), run_of(10, 0)});
  EXPECT_EQ(result.runs, 5);
  EXPECT_EQ(result.distinct, 4) << "a repeat is counted once";
  const Interval share = wilson_interval(2, 4);
  EXPECT_THAT(result.found, FieldsAre(0.5, FieldsAre(share.lower, share.upper)));
  EXPECT_THAT(result.running_time,
              Optional(FieldsAre((10 + 30 + 100 + 100) / 2.0,
                                 FieldsAre(testing::Lt(120), testing::Gt(120)))));
  EXPECT_FALSE(result.returned_running_time) << "no run returned a point";
}

TEST(Result, KnowsTheReturnedPointApart) {
  Outcome kept = run_of(10, 0);
  kept.verdict.returned_solved = true;
  kept.verdict.returned_optimality_gap = 0;
  Outcome lost = run_of(10, 0);
  lost.verdict.returned_optimality_gap = 6;
  const Result result = result_of({kept, lost, run_of(30, 0)});
  EXPECT_EQ(result.distinct, 3) << "two differ in what they returned alone";
  EXPECT_EQ(result.found.share, 1);
  EXPECT_DOUBLE_EQ(result.returned.share, 1.0 / 3);
  EXPECT_DOUBLE_EQ(result.running_time->value, (10 + 10 + 30) / 3.0);
  EXPECT_EQ(result.returned_running_time->value, 10 + 100 + 100);
  EXPECT_EQ(result.gap, 6);
}

TEST(Result, SaysNeverWhereNoRunSolved) {
  Outcome nothing = run_of({}, 0);
  nothing.verdict.optimality_gap.reset();
  nothing.steps.clear();
  nothing.failure = "broken";
  const Result result = result_of({nothing});
  EXPECT_FALSE(result.running_time);
  EXPECT_FALSE(result.seconds_to_solve);
  EXPECT_EQ(result.gap, infinity);
  EXPECT_EQ(result.failed, 1);
  EXPECT_EQ(result.found.share, 0);
  EXPECT_GT(result.found.interval.upper, 0.5) << "one run says little";
}

using CellResults = HeldCampaign;

TEST_F(CellResults, AreOfEveryCellWithWhatEveryRunSpentUntilItSolved) {
  hold({patient("quick", 3), patient("slow", 30), patient("steep", 5, true)},
       {"budgets = [10, 40]\ninstances = 4\nformulations = \"*\"\n"});
  int runs = 0;
  const auto found = cell_results(*campaign_, *store_, [&](const StoredRun&) { ++runs; });
  ASSERT_EQ(found.size(), 2U * (2 + 2 + 1)) << "two budgets, two formulations but for the last";
  EXPECT_EQ(runs, 10 * 4) << "it told of every run that it read";
  for (const CellResult& result : found) {
    const Cell& cell = result.cell->cell;
    ASSERT_EQ(result.outcomes.size(), 4U) << cell.solver;
    for (std::size_t i = 0; i < 4; ++i) {
      const Outcome& outcome = result.outcomes[i];
      EXPECT_EQ(outcome.instance, static_cast<int>(i) + 1);
      EXPECT_EQ(outcome.evaluations, cell.budget);
      EXPECT_EQ(outcome.verdict.solved, cell.solver != "slow" || cell.budget == 40)
          << cell.formulation;
      if (cell.solver != "quick") continue;
      EXPECT_EQ(outcome.verdict.evaluations_to_solve, 4);
      EXPECT_FALSE(outcome.verdict.returned_solved) << "it hands over the end of the box";
    }
  }
  EXPECT_EQ(largest_budgets(found), (std::map<std::size_t, std::int64_t>{{0, 40}}));
}

TEST_F(CellResults, AreThoseOfAWholeCampaign) {
  hold({patient("quick", 3)}, {"budgets = 10\ninstances = 3\nformulations = \"*\"\n"}, {1, 2});
  EXPECT_THAT(complaint_of([&] { return results(); }), HasSubstr("3 of 6 runs are there"));
}

using Compared = HeldCampaign;

/// One solver on one problem in 2 of its formulations, at 2 prices of a gradient, by two parts.
TEST_F(Compared, AreResultsOfOnePartUnderTheSameConditions) {
  Solver quick = patient("quick", 3);
  quick.content = "a user's, which may ask for gradients";
  const std::string prices = "budgets = 10\ngradient_prices = [0, \"n\"]\n";
  hold({quick}, {prices + "instances = 5\n",
                 prices + "instances = 2\nseeds = 3\nformulations = \"count\"\n"});
  const std::vector<CellResult> all = results();
  ASSERT_EQ(all.size(), 4U);
  const Comparison comparison = comparison_of(*campaign_, all, {});
  ASSERT_EQ(comparison.results.size(), 2U) << "two formulations at the price n";
  EXPECT_EQ(comparison.problems(), (std::vector<std::size_t>{0}));
  for (const CellResult& result : comparison.results) {
    EXPECT_EQ(result.cell->cell.gradient_price, "n");
    ASSERT_EQ(result.outcomes.size(), 5U);
    EXPECT_EQ(result.outcomes[4].instance, 5);
    EXPECT_EQ(comparison.problem_of(result).name, "valley");
  }
  // An outcome for each instance, of the run that is asked for.
  const Comparison again = comparison_of(*campaign_, all, {.part = 1, .run = 2});
  ASSERT_EQ(again.results.size(), 1U) << "the other formulation has no third run";
  const CellResult& result = again.results.front();
  EXPECT_EQ(result.cell->seeds, 3);
  ASSERT_EQ(result.outcomes.size(), 2U);
  EXPECT_EQ(result.outcomes[1].instance, 2);
  const auto whole = std::ranges::find(all, result.cell, &CellResult::cell);
  ASSERT_NE(whole, all.end());
  EXPECT_EQ(&result.outcomes[1], &whole->outcomes[5]);
}

TEST(Ceiling, IsTheTrueValuesAtTheOptimumOfTheSurrogate) {
  const auto near = [](double value) { return testing::DoubleNear(value, 1e-4); };
  Problem problem = valley_problem();
  EXPECT_THAT(ceiling(problem, 0.125),
              Optional(FieldsAre(near(0.625), near(0.125), Optional(near(0.125)))));
  problem.true_values = [](const Vector& x) { return TrueValues{0, x[0] > 0.6 ? 1.0 : 0.0}; };
  problem.smoothed = [true_values = problem.true_values](double smoothing) {
    Problem smooth = valley(smoothing);
    smooth.true_values = true_values;
    return smooth;
  };
  EXPECT_FALSE(ceiling(problem, 0.25)->optimality_gap) << "the optimum is truly infeasible";
  problem.smoothed = nullptr;
  EXPECT_FALSE(ceiling(problem, 0.25)) << "without a surrogate";
}

}  // namespace
}  // namespace ricochet::comparison
