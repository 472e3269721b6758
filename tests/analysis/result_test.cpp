#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "src/analysis/results.h"

namespace ricochet::comparison {
namespace {

/// A run that solved after so many evaluations of 100, or not at all.
Outcome run_of(std::optional<std::int64_t> solved, double optimality_gap) {
  Outcome outcome;
  outcome.evaluations = 100;
  outcome.verdict.solved = solved.has_value();
  outcome.verdict.evaluations_to_solve = solved;
  outcome.verdict.optimality_gap = optimality_gap;
  outcome.steps = {{solved.value_or(50), 0.1, optimality_gap}};
  outcome.terminations = {"done", "done", "lost"};
  return outcome;
}

TEST(Result, SumsUpTheRuns) {
  const Result result = result_of({run_of(10, 0), run_of(30, 0), run_of({}, 2), run_of({}, 4)});
  EXPECT_EQ(result.runs, 4);
  EXPECT_EQ(result.distinct, 4);
  EXPECT_EQ(result.found.share, 0.5);
  EXPECT_LT(result.found.interval.lower, 0.2);
  EXPECT_GT(result.found.interval.upper, 0.8);
  ASSERT_TRUE(result.running_time);
  EXPECT_EQ(result.running_time->value, (10 + 30 + 100 + 100) / 2.0);
  EXPECT_LT(result.running_time->interval.lower, 120);
  EXPECT_GT(result.running_time->interval.upper, 120);
  EXPECT_FALSE(result.returned_running_time) << "no run returned a point";
}

TEST(Result, KnowsTheReturnedPointApart) {
  Outcome kept = run_of(10, 0);
  kept.verdict.returned_solved = true;
  kept.verdict.returned_optimality_gap = 0;
  Outcome lost = run_of(10, 0);
  lost.verdict.returned_optimality_gap = 6;
  Outcome none = run_of(30, 0);
  const Result result = result_of({kept, lost, none});
  EXPECT_EQ(result.distinct, 3) << "two differ in what they returned alone";
  EXPECT_EQ(result.found.share, 1);
  EXPECT_DOUBLE_EQ(result.returned.share, 1.0 / 3);
  EXPECT_DOUBLE_EQ(result.running_time->value, (10 + 10 + 30) / 3.0);
  EXPECT_EQ(result.returned_running_time->value, 10 + 100 + 100);
  EXPECT_EQ(result.gap, 6);
}

TEST(Result, CountsRepeatsOnce) {
  const Result result = result_of({run_of(10, 0), run_of(10, 0), run_of(10, 0), run_of({}, 2)});
  EXPECT_EQ(result.runs, 4);
  EXPECT_EQ(result.distinct, 2);
  EXPECT_EQ(result.found.share, 0.5);
}

TEST(Result, SaysNeverWhereNoRunSolved) {
  Outcome nothing = run_of({}, 0);
  nothing.verdict.optimality_gap.reset();
  nothing.steps.clear();
  nothing.failure = "broken";
  const Result result = result_of({nothing});
  EXPECT_FALSE(result.running_time);
  EXPECT_FALSE(result.seconds_to_solve);
  EXPECT_TRUE(std::isinf(result.gap));
  EXPECT_EQ(result.failed, 1);
  EXPECT_EQ(result.found.share, 0);
  EXPECT_GT(result.found.interval.upper, 0.5) << "one run says little";
}

}  // namespace
}  // namespace ricochet::comparison
