#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "src/studies/surrogate/study.h"

namespace ricochet::studies::surrogate {
namespace {

const ContinuationStudy& study() {
  static const ContinuationStudy made = study_continuation({1, {200}});
  return made;
}

/// Shown as quiet up to 7 rad/s, truly quiet up to 6 rad/s.
Problem misleading() {
  Problem problem;
  problem.name = "misleading";
  problem.lower = Vector::Zero(1);
  problem.upper = Vector::Constant(1, 10);
  problem.start = problem.lower;
  problem.constraints = 1;
  problem.evaluate = [](const Vector& x) { return Values{-x[0], Vector::Constant(1, x[0] - 7)}; };
  problem.true_values = [](const Vector& x) { return TrueValues{-x[0], std::max(0.0, x[0] - 6)}; };
  problem.best_known = -6;
  return problem;
}

/// The run of a solver that asks for this speed alone.
RunRecord run_to(double omega) {
  Solver solver;
  solver.name = "guess";
  solver.solve = [omega](Evaluator& evaluator, const Vector&, Random&) {
    evaluator.values(Vector::Constant(1, omega));
    return SolverTermination{"guessed " + std::to_string(static_cast<int>(omega))};
  };
  return run(misleading(), solver, Budget{5}, 0);
}

TEST(ContinuationRuns, AreSolvedWithinAHundredthBelowTheTrueThreshold) {
  const ContinuationRuns runs = runs_of("C0", misleading(), {run_to(5.995), run_to(5.8)});
  EXPECT_EQ(runs.solver, "guess");
  EXPECT_EQ(runs.budget, 5);
  EXPECT_EQ(runs.solved, 1);
  EXPECT_NEAR(runs.worst_optimality_gap, 0.2, 1e-12);
  EXPECT_EQ(runs.exit, "guessed 5");
}

TEST(ContinuationRuns, AreNotSolvedByASpeedThatOnlyLooksQuiet) {
  const ContinuationRuns runs = runs_of("C0", misleading(), {run_to(6.5), run_to(6)});
  EXPECT_EQ(runs.solved, 1);
  EXPECT_TRUE(std::isinf(runs.worst_optimality_gap));
  EXPECT_EQ(runs.exit, "guessed 6");
}

TEST(ContinuationStudy, HasARowForEveryClaimedCaseAndSolver) {
  std::map<std::string, int> rows;
  for (const ContinuationRuns& row : study().rows) ++rows[row.solver];
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& [solver, count] : rows) EXPECT_EQ(count, 10) << solver;
}

TEST(ContinuationStudy, HelpsSlsqpToTheFastestQuietSpeed) {
  std::map<std::string, int> solved;
  for (const ContinuationRuns& row : study().rows) solved[row.solver] += row.solved;
  EXPECT_GE(solved["continuation-nlopt-slsqp"], 9);
  EXPECT_LE(solved["nlopt-slsqp"], 5);
}

TEST(ContinuationStudy, AddsUpTheRunsOfEverySolver) {
  const report::Json data = data_of(study());
  ASSERT_EQ(data["columns"].size(), 4U);
  ASSERT_EQ(data["cases"].size(), 10U + 1U);
  std::map<std::string, int> solved;
  for (const ContinuationRuns& row : study().rows) solved[row.solver] += row.solved;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string solver = data["columns"][k]["solver"];
    EXPECT_EQ(data["cases"].back()["runs"][k]["solved"], solved.at(solver)) << solver;
    EXPECT_EQ(data["columns"][k]["share"], solved.at(solver) / 10.0) << solver;
  }
}

}  // namespace
}  // namespace ricochet::studies::surrogate
