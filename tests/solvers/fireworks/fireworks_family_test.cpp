// What all members of the family promise beside what every solver does.

#include <gtest/gtest.h>

#include <cmath>

#include "ricochet/run.h"
#include "solvers/fireworks/fireworks.h"
#include "tests/solvers/fireworks/asked_points.h"
#include "tests/support/problems.h"

namespace ricochet::fireworks {
namespace {

class Family : public testing::TestWithParam<Solver> {
 protected:
  const Solver& solver() const { return GetParam(); }
};

TEST_P(Family, AsksForNothingOnceItIsRefused) {
  for (const std::int64_t budget : {1, 2, 5, 6, 17, 60, 210, 304, 311, 700}) {
    for (const Problem& problem : {sphere(3, 7), plateau(1), never_a_number(2), disc()}) {
      const RunRecord record = run(problem, solver(), {budget}, 1);
      EXPECT_EQ(record.ledger.charged, budget) << problem.name;
      EXPECT_EQ(record.ledger.refused, 1) << problem.name;
      EXPECT_EQ(record.terminations.size(), 1U) << problem.name;
    }
  }
}

TEST_P(Family, SearchesABoxWithoutWidthInACoordinate) {
  Problem problem = sphere(3, 0);
  problem.lower[1] = problem.upper[1] = problem.start[1] = 5;
  for (const Vector& x : asked_points(problem, solver(), 500)) ASSERT_EQ(x[1], 5);
  const RunRecord record = run(problem, solver(), {3000}, 1);
  EXPECT_LT(record.trace.back().true_values.objective, 25 + 30);
}

TEST_P(Family, StaysInBoxesOfAnyPlaceAndWidth) {
  Random random(1);
  for (int trial = 0; trial < 20; ++trial) {
    Problem problem = sphere(2, 0);
    const double scale = std::pow(10, 6 * uniform(random) - 3);
    problem.lower = scale * normal(2, random);
    problem.upper = problem.lower + scale * normal(2, random).cwiseAbs();
    problem.start = (problem.lower + problem.upper) / 2;
    for (const Vector& x : asked_points(problem, solver(), 700)) {
      ASSERT_TRUE((x.array() >= problem.lower.array()).all());
      ASSERT_TRUE((x.array() <= problem.upper.array()).all());
    }
  }
}

TEST_P(Family, PrefersFeasiblePointsToBetterOnes) {
  // The objective leads away from the feasible corner.
  Problem problem = box_problem("corner", 2, 0, 10, 9, [](const Vector& x) { return -x.sum(); });
  problem.constraints = 1;
  problem.evaluate = [](const Vector& x) {
    return Values{-x.sum(), Vector::Constant(1, x.sum() - 2)};
  };
  const RunRecord record = run(problem, solver(), {3000}, 1);
  EXPECT_EQ(record.trace.back().true_values.violation, 0);
  EXPECT_LT(record.trace.back().true_values.objective, -1.9);
}

TEST_P(Family, ComesNearAnEquation) {
  const RunRecord record = run(arc(), solver(), {20000}, 1);
  EXPECT_LT(record.trace.back().true_values.violation, 1e-3);
}

TEST_P(Family, GoesOnWhereNothingIsANumberAtFirst) {
  const RunRecord record = run(half_a_number(), solver(), {3000}, 0);
  EXPECT_LT(record.trace.back().true_values.objective, 100);
}

std::string name_of(const testing::TestParamInfo<Solver>& tested) {
  return test_name(tested.param.name);
}

INSTANTIATE_TEST_SUITE_P(Of, Family, testing::ValuesIn(family()), name_of);

}  // namespace
}  // namespace ricochet::fireworks
