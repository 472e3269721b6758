#include "solvers/plateau_search/plateau_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "solvers/plateau_search/sight.h"
#include "src/core/run.h"
#include "tests/solvers/test_problems.h"

namespace ricochet {
namespace {

/// Every point at which values are asked for, in order.
std::vector<Vector> asked_points(const Problem& problem, std::int64_t evaluations) {
  std::vector<Vector> asked;
  Problem recorded = problem;
  recorded.evaluate = [&](const Vector& x) {
    asked.push_back(x);
    return problem.evaluate(x);
  };
  run(recorded, plateau_search(), {evaluations}, 1);
  return asked;
}

/// How many steps lie above the least of a staircase of cells that grow towards it.
Problem terraces(Eigen::Index n) {
  return box_problem("terraces", n, -1, 1, 0.9, [](const Vector& x) {
    return std::floor(20 * (x.array() - 0.37).abs().maxCoeff());
  });
}

TEST(PlateauSearch, StopsExactly) {
  for (const std::int64_t budget : {1, 7, 100, 1000}) {
    const RunRecord record = run(terraces(4), plateau_search(), {budget}, 1);
    EXPECT_EQ(record.ledger.charged, budget);
    EXPECT_EQ(record.ledger.refused, 1);
  }
}

TEST(PlateauSearch, AsksForNoPointTwice) {
  // Of one variable steps end on the boundary all the time.
  for (const Problem& problem : {plateau(1), plateau(3), staircase(), terraces(2)}) {
    Problem without = problem;
    without.differentiate = nullptr;
    without.smoothed = nullptr;
    std::set<std::vector<double>> distinct;
    const std::vector<Vector> asked = asked_points(without, 3000);
    ASSERT_EQ(asked.size(), 3000U) << problem.name;
    for (const Vector& x : asked) distinct.insert({x.begin(), x.end()});
    EXPECT_EQ(distinct.size(), asked.size()) << problem.name;
  }
}

TEST(PlateauSearch, BeginsAgainHoweverWideThePlateau) {
  // Two cells are lower than all else; only new rounds come to the far one.
  const Problem problem = box_problem("two-cells", 2, 0, 1, 0.1, [](const Vector& x) {
    if ((x.array() - 0.1).abs().maxCoeff() < 0.15) return 1.0;
    return (x.array() - 0.9).abs().maxCoeff() < 0.02 ? 0.0 : 2.0;
  });
  int found = 0;
  for (int k = 0; k < 10; ++k) {
    const RunRecord record = run(problem, plateau_search(), {5000}, k);
    found += record.trace.back().truth.objective == 0;
  }
  EXPECT_GE(found, 8);
}

TEST(PlateauSearch, HandsOverTheBestPointThatItSaw) {
  const RunRecord record = run(with_idle_knob(terraces(3)), plateau_search(), {500}, 2);
  ASSERT_TRUE(record.handed_over);
  EXPECT_EQ(record.handed_over->truth.objective, record.trace.back().truth.objective);
}

TEST(PlateauSearch, LeavesCoordinatesWithoutRoomAlone) {
  Problem problem = terraces(3);
  problem.lower[1] = problem.upper[1] = problem.start[1] = 0.25;
  std::set<std::vector<double>> distinct;
  for (const Vector& x : asked_points(problem, 500)) {
    EXPECT_EQ(x[1], 0.25);
    EXPECT_TRUE(distinct.insert({x.begin(), x.end()}).second);
  }
}

TEST(PlateauSearch, TakesNoEqualities) {
  EXPECT_FALSE(plateau_search().accepts(arc()));
  EXPECT_TRUE(plateau_search().accepts(disc()));
}

TEST(PlateauSearch, DescendsWhereTheSurrogateTellsTheWay) {
  // Whole numbers of steps, and below them a bowl of which a 20-dimensional drift sees next to
  // nothing in 600 evaluations.
  Problem problem = box_problem("hidden-bowl", 20, 0, 1, 0.9, [](const Vector& x) {
    return std::floor(10 * (x.array() - 0.37).square().sum());
  });
  Problem bowl = problem;
  bowl.evaluate = [](const Vector& x) {
    return Values{10 * (x.array() - 0.37).square().sum(), {}};
  };
  bowl.truth = [evaluate = problem.evaluate](const Vector& x) { return truth_of(evaluate(x)); };
  differentiate_by(bowl, [](const Vector& x) -> Vector { return 20 * (x.array() - 0.37); });
  Problem shown = bowl;
  shown.smoothed = [problem, bowl](double width) { return width > 0 ? bowl : problem; };
  EXPECT_EQ(run(shown, plateau_search(), {600}, 1).trace.back().truth.objective, 0);
  EXPECT_GT(run(problem, plateau_search(), {600}, 1).trace.back().truth.objective, 0);
}

}  // namespace
}  // namespace ricochet
