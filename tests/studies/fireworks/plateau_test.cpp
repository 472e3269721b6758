#include <gtest/gtest.h>

#include "src/studies/fireworks/study.h"

namespace ricochet::studies::fireworks {
namespace {

double value(const Problem& problem, double x) {
  return problem.evaluate(Vector::Constant(1, x)).objective;
}

TEST(Plateaus, HaveATargetOfWidthOne) {
  for (const Problem& problem : {needle(500), logarithmic_staircase(500)}) {
    for (const double x : {500.0, 500.5, 501.0}) EXPECT_EQ(value(problem, x), 0);
    EXPECT_EQ(value(problem, 499.99), 1);
    EXPECT_EQ(value(problem, 501.01), 1);
  }
}

TEST(Plateaus, AreFlatOrAStaircaseElsewhere) {
  for (const double x : {0.0, 300.0, 1000.0}) EXPECT_EQ(value(needle(500), x), 1);
  EXPECT_EQ(value(logarithmic_staircase(500), 497), 2);
  EXPECT_EQ(value(logarithmic_staircase(500), 504), 2);
  EXPECT_EQ(value(logarithmic_staircase(500), 504.1), 3);
  EXPECT_EQ(value(logarithmic_staircase(0), 1000), 10);
}

TEST(Plateaus, AreHitByRandomSearchAsProbabilityHasIt) {
  const report::Json data = plateau_data(400);
  for (const report::Json& landscape : data["landscapes"]) {
    const report::Json& last = landscape["solvers"].back();
    EXPECT_EQ(last["solver"], "random-search");
    for (const report::Json& cell : last["cells"]) EXPECT_NEAR(cell["rate"], 0.632, 0.08);
  }
}

}  // namespace
}  // namespace ricochet::studies::fireworks
