#include "solvers/mads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "problems/classic/classic.h"
#include "ricochet/run.h"
#include "src/core/evaluator.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

class Mads : public testing::TestWithParam<Settings> {
 protected:
  /// The best feasible objective after one call of solve.
  static double end_of(const Problem& problem, std::uint64_t seed = 1);
};

double Mads::end_of(const Problem& problem, std::uint64_t seed) {
  Scorer scorer(problem);
  Evaluator evaluator(problem, {50'000}, &scorer);
  Random random(seed);
  const SolverTermination exit = mads(GetParam()).solve(evaluator, problem.start, random);
  EXPECT_EQ(exit.reason, "the mesh is fine") << problem.name;
  EXPECT_EQ(scorer.best()->true_values.violation, 0) << problem.name;
  return scorer.best()->true_values.objective;
}

Problem classic_problem(const std::string& name) {
  for (Problem& problem : classic::classic_problems()) {
    if (problem.name == name) return problem;
  }
  throw std::invalid_argument(name);
}

TEST_P(Mads, ConvergesOnASphere) {
  for (const Eigen::Index n : {1, 2, 5}) EXPECT_LT(end_of(sphere(n, 3)), 1e-3) << n;
}

TEST_P(Mads, ConvergesInRosenbrocksValley) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    EXPECT_LT(end_of(classic_problem("classic-rosenbrock-2"), seed), 0.05);
  }
}

/// Inequalities alone, and one optimum; published.
TEST_P(Mads, ConvergesOnProblemsOfHockAndSchittkowski) {
  for (const char* name : {"hs-12", "hs-22", "hs-29", "hs-35", "hs-43", "hs-65", "hs-76"}) {
    const Problem problem = classic_problem(name);
    const double best = *problem.best_known;
    EXPECT_NEAR(end_of(problem), best, 2e-2 * std::max(1.0, std::abs(best))) << name;
  }
}

TEST_P(Mads, FindsPointsOnAnArc) {
  if (GetParam() == Settings::tuned) GTEST_SKIP() << "it stops when polls are at 1e-4 of the box";
  int found = 0, good = 0;
  for (int number = 0; number < 10; ++number) {
    const TrueValues end = run(arc(), mads(GetParam()), {5000}, number).trace.back().true_values;
    found += end.violation == 0 ? 1 : 0;
    good += end.violation == 0 && end.objective <= -1 ? 1 : 0;
  }
  EXPECT_GE(found, 6) << "an equation to 1e-6";
  EXPECT_GE(good, 3);
}

/// The largest x + y on [0, 10]^2 at which a count, floor(x) + floor(2 y), is at most 7. With a
/// first part of a it is below (a + 1) + (8 - a) / 2, which is most, 8.5, next to (8, 1/2).
Problem steps() {
  Problem problem = box_problem("steps", 2, 0, 10, 9, [](const Vector& x) { return -x.sum(); });
  problem.constraints = 1;
  problem.best_known = -8.5;
  problem.evaluate = [](const Vector& x) {
    return Values{-x.sum(), Vector::Constant(1, std::floor(x[0]) + std::floor(2 * x[1]) - 7)};
  };
  return problem;
}

TEST_P(Mads, ComesToTheEdgeOfAStepThatIsAConstraint) {
  const RunRecord record = run(steps(), mads(GetParam()), {2000}, 0);
  EXPECT_EQ(record.trace.back().true_values.violation, 0);
  EXPECT_NEAR(record.trace.back().true_values.objective, -8.5, 0.01);
}

TEST_P(Mads, StaysInTheBoxWhateverItAsksFor) {
  for (Problem problem : {sphere(3, 130), disc(), steps()}) {
    int asked = 0;
    problem.evaluate = [&asked, problem](const Vector& x) {
      EXPECT_TRUE((x.array() >= problem.lower.array()).all()) << x.transpose();
      EXPECT_TRUE((x.array() <= problem.upper.array()).all()) << x.transpose();
      ++asked;
      return problem.evaluate(x);
    };
    run(problem, mads(GetParam()), {1000}, 0);
    EXPECT_GE(asked, 1000);
  }
}

TEST_P(Mads, ReachesABound) {
  EXPECT_EQ(end_of(sphere(3, 130)), 3 * 30 * 30);
}

TEST_P(Mads, AsksForNoPointTwiceFromOneStart) {
  for (Problem problem : {sphere(1, 3), plateau(2)}) {
    std::vector<Vector> asked;
    problem.evaluate = [&asked, problem](const Vector& x) {
      EXPECT_EQ(std::count(asked.begin(), asked.end(), x), 0) << x.transpose();
      asked.push_back(x);
      return problem.evaluate(x);
    };
    end_of(problem);
  }
}

TEST_P(Mads, EndsOnAPlateauSoonAndIsStartedAgain) {
  const RunRecord record = run(plateau(2), mads(GetParam()), {1000}, 0);
  EXPECT_GT(record.terminations.size(), 10U);
  EXPECT_EQ(record.terminations.front().reason, "the mesh is fine");
}

TEST_P(Mads, LeavesACoordinateAloneWhoseBoxHasNoWidth) {
  Problem problem = sphere(3, 3);
  problem.lower[1] = problem.upper[1] = problem.start[1] = 5;
  EXPECT_NEAR(end_of(problem), 4, 1e-3);
}

TEST_P(Mads, SpendsItsBudgetToTheLastEvaluation) {
  const Problem problem = disc();
  for (std::int64_t budget = 0; budget < 60; ++budget) {
    Evaluator evaluator(problem, {budget});
    Random random(1);
    const SolverTermination exit = mads(GetParam()).solve(evaluator, problem.start, random);
    EXPECT_EQ(exit.reason, "stopped by the evaluator");
    EXPECT_EQ(evaluator.ledger().charged, budget);
  }
}

INSTANTIATE_TEST_SUITE_P(With, Mads, testing::Values(Settings::own, Settings::tuned),
                         [](const auto& tested) {
                           return tested.param == Settings::own ? "OwnSettings" : "TunedSettings";
                         });

}  // namespace
}  // namespace ricochet
