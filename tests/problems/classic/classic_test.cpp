#include "problems/classic/classic.h"

#include <gtest/gtest.h>

#include <set>

#include "src/core/instance.h"
#include "tests/problems/classic/claims.h"

namespace ricochet::classic {
namespace {

TEST(Classic, HasNamesOfItsOwn) {
  std::set<std::string> names;
  for (const Problem& problem : classic_problems()) {
    EXPECT_TRUE(names.insert(problem.name).second) << problem.name;
    EXPECT_TRUE(problem.name.starts_with("classic-") || problem.name.starts_with("hs-"));
  }
  EXPECT_EQ(names.size(), 27U + 116);
}

TEST(Classic, StatesWhatItIs) {
  for (const Problem& problem : classic_problems()) expect_statement(problem);
}

TEST(Classic, HasNoRandomPointBelowTheBest) {
  for (const Problem& problem : classic_problems()) expect_nothing_better(problem);
}

TEST(Classic, KeepsTheBestInInstances) {
  for (const Problem& problem : classic_problems()) expect_best_in_instances(problem);
}

TEST(Classic, HasTheDerivativesOfDifferences) {
  int without = 0;
  for (const Problem& problem : classic_problems()) {
    if (problem.differentiate) {
      expect_derivatives(problem, 1e-5);
    } else {
      ++without;
      EXPECT_EQ(problem.name, "classic-step-5");
    }
  }
  EXPECT_EQ(without, 1);
}

TEST(Classic, TurnsWhereTheBestPointIsBestEverywhere) {
  for (const Problem& problem : classic_problems()) {
    const bool test_function = problem.name.starts_with("classic-");
    if (test_function) {
      EXPECT_EQ(problem.rotates, problem.name != "classic-schwefel-2.26-5") << problem.name;
    }
    if (!problem.rotates) continue;
    // Far outside the box, too, nothing is better.
    Random random(seed_of(problem.name, "far", 0, 0));
    Problem wide = problem;
    wide.lower = 3 * problem.lower - 2 * problem.upper;
    wide.upper = 3 * problem.upper - 2 * problem.lower;
    for (int i = 0; i < 1000; ++i) {
      const TrueValues true_values = true_values_at(problem, uniform_point(wide, random));
      if (true_values.violation > 0) continue;
      EXPECT_GE(true_values.objective, *problem.best_known - 1e-9) << problem.name;
    }
  }
}

}  // namespace
}  // namespace ricochet::classic
