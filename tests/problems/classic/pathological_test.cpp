#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "problems/classic/classic.h"
#include "tests/problems/classic/claims.h"

namespace ricochet::classic {
namespace {

Problem pathological(const std::string& name) {
  return named(pathological_family().problems, "pathological-" + name);
}

const Vector near{{0.1, 0.1}}, far{{0.9, 0.9}}, between{{0.35, 0.25}};

TEST(Pathological, HaveTheBestValueOfTheirTrueObjective) {
  for (const Problem& problem : pathological_family().problems) {
    SCOPED_TRACE(problem.name);
    EXPECT_TRUE(problem.hazardous);
    if (!problem.best_point) continue;
    EXPECT_EQ(true_values_at(problem, *problem.best_point).objective, *problem.best_known);
    expect_nothing_better(problem);
  }
}

/// What scores a run, a target or a hash asks for everywhere.
TEST(Pathological, HaveTrueValuesEverywhere) {
  for (const char* name : {"throws", "hangs", "crashes", "no-number", "infinite"}) {
    EXPECT_DOUBLE_EQ(true_values_at(pathological(name), near).objective, 0.04) << name;
    EXPECT_DOUBLE_EQ(true_values_at(pathological(name), far).objective, 0.36) << name;
  }
}

TEST(Pathological, FailWhereTheySay) {
  EXPECT_TRUE(std::isnan(pathological("no-number").evaluate(far).objective));
  EXPECT_TRUE(pathological("no-number").differentiate(far).gradient.array().isNaN().all());
  EXPECT_EQ(pathological("infinite").evaluate(far).objective,
            std::numeric_limits<double>::infinity());
  EXPECT_THROW(pathological("throws").evaluate(near), std::runtime_error);
  EXPECT_THROW(pathological("throws").residuals(near), std::runtime_error);
  EXPECT_DEATH(pathological("crashes").evaluate(near), "");
  EXPECT_EQ(pathological("plateau").evaluate(near).objective,
            pathological("plateau").evaluate(far).objective);
  EXPECT_GT(pathological("cliff").evaluate(Vector{{0.3 - 1e-9, 0}}).objective, 0.99);
  for (const Vector& x : {near, far, between}) {
    EXPECT_GT(true_values_at(pathological("infeasible"), x).violation, 1);
  }
}

TEST(Pathological, HaveTheirDerivativesElsewhere) {
  for (const Problem& problem : pathological_family().problems) {
    SCOPED_TRACE(problem.name);
    const Derivatives told = problem.differentiate(between);
    EXPECT_EQ(all_of(told.values), all_of(problem.evaluate(between)));
    expect_columns(
        problem, between, told.gradient.transpose(),
        [&](const Vector& x) { return all_of(problem.evaluate(x)).head(1).eval(); }, 1e-8);
  }
}

}  // namespace
}  // namespace ricochet::classic
