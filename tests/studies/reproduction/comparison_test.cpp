#include "src/studies/reproduction/comparison.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet::studies::reproduction {
namespace {

/// |x - 0.5| on [0, 1], with derivatives at a smoothing width, which changes nothing else.
Problem valley(double width) {
  Problem problem;
  problem.name = "valley";
  problem.lower = Vector::Zero(1);
  problem.upper = Vector::Ones(1);
  problem.start = Vector::Zero(1);
  problem.best_known = 0.0;
  problem.evaluate = [](const Vector& x) { return Values{std::abs(x[0] - 0.5), {}}; };
  if (width > 0) {
    problem.differentiate = [evaluate = problem.evaluate](const Vector& x) {
      return Derivatives{evaluate(x), Vector::Constant(1, x[0] > 0.5 ? 1 : -1), Matrix(0, 1)};
    };
  }
  problem.smoothed = valley;
  return problem;
}

/// Asks for the start `wasted` times over, each time a little beside it, then for the middle.
Solver patient(std::string name, int wasted, bool needs_derivatives) {
  Solver solver;
  solver.name = std::move(name);
  solver.accepts = [needs_derivatives](const Problem& problem) {
    return static_cast<bool>(problem.differentiate) == needs_derivatives;
  };
  solver.solve = [wasted](Evaluator& evaluator, const Vector& start, Random&) {
    const Problem& problem = evaluator.problem();
    for (int i = 0; i < wasted; ++i) {
      const double shift = 1e-3 * i * (problem.upper[0] > start[0] + 0.1 ? 1 : -1);
      evaluator.objective(start + Vector::Constant(1, shift));
    }
    evaluator.objective(0.5 * (problem.lower + problem.upper));
    return SolverExit("done");
  };
  return solver;
}

std::vector<ContestResult> compare_patient_ones() {
  return compare(
      {{.stated = valley(0), .width = 0.25, .tolerance = 1e-9}},
      {patient("quick", 3, false), patient("slow", 30, false), patient("steep", 5, true)},
      {4, Budget{20}});
}

TEST(Comparison, ShowsEverySolverTheFirstFormThatItAccepts) {
  const auto results = compare_patient_ones();
  ASSERT_EQ(results.size(), 1U);
  ASSERT_EQ(results[0].standings.size(), 3U);
  EXPECT_EQ(results[0].standings[0].form, "count");
  EXPECT_EQ(results[0].standings[2].form, "surrogate");
}

TEST(Comparison, CountsEveryRunWithWhatItSpentUntilItSolved) {
  const auto results = compare_patient_ones();
  const Standing& quick = results[0].standings[0];
  ASSERT_EQ(quick.evaluations.size(), 4U);
  for (const Effort& effort : quick.evaluations) {
    EXPECT_TRUE(effort.reached);
    EXPECT_EQ(effort.spent, 4);
  }
  const Standing& slow = results[0].standings[1];
  for (const Effort& effort : slow.evaluations) {
    EXPECT_FALSE(effort.reached);
    EXPECT_EQ(effort.spent, 20);
  }
}

TEST(Comparison, FollowsTheMedianFromTheFirstEvaluationToTheLast) {
  const auto results = compare_patient_ones();
  const Progression& quick = results[0].by_evaluations[0];
  EXPECT_EQ(quick.solver, "quick");
  EXPECT_EQ(quick.price.front(), 1);
  EXPECT_NEAR(quick.price.back(), 20, 1e-9);
  EXPECT_NEAR(quick.median.back(), 0, 1e-12);
  for (std::size_t k = 0; k < quick.price.size(); ++k) {
    EXPECT_LE(quick.lower[k], quick.median[k]);
    EXPECT_LE(quick.median[k], quick.upper[k]);
    if (quick.price[k] < 4) {
      EXPECT_GT(quick.median[k], 1e-4);
    } else {
      EXPECT_NEAR(quick.median[k], 0, 1e-12);
    }
  }
}

TEST(Comparison, LeavesOutWhatNoRunHasReachedYet) {
  Question question{.stated = valley(0), .tolerance = 1e-9};
  question.stated.truth = [](const Vector&) { return Truth{0.0, 1.0}; };
  const auto results = compare({question}, {patient("quick", 3, false)}, {4, Budget{20}});
  EXPECT_TRUE(results[0].by_evaluations[0].price.empty());
  EXPECT_TRUE(std::isinf(results[0].standings[0].regrets[0]));
}

TEST(Comparison, ShowsWhatIsBetterThanTheBestKnown) {
  Question question{.stated = valley(0), .tolerance = 1e-9};
  question.stated.best_known = 0.25;
  const auto results = compare({question}, {patient("quick", 3, false)}, {4, Budget{20}});
  ASSERT_EQ(results[0].standings[0].regrets.size(), 4U);
  for (const double regret : results[0].standings[0].regrets) EXPECT_NEAR(regret, -0.25, 1e-12);
}

}  // namespace
}  // namespace ricochet::studies::reproduction
