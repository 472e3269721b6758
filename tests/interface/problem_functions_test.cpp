// The functions of libricochet.so that do what the pointers of a ricochet_problem do.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "ricochet/problem.h"
#include "src/core/instance.h"
#include "src/studies/suite/suite.h"
#include "tests/interface/opened.h"

namespace ricochet::interface {
namespace {

using testing::Each;
using testing::HasSubstr;

Problem problem_named(const std::string& name, int number) {
  for (const Problem& problem : every_problem(suite_families())) {
    if (problem.name == name) return instance(problem, number);
  }
  throw std::out_of_range(name);
}

/// Somewhere in the box: `share` of the way along every edge.
std::vector<double> point(const ricochet_problem* problem, double share) {
  std::vector<double> x;
  for (int i = 0; i < problem->dimension; ++i) {
    x.push_back(problem->lower[i] + share * (problem->upper[i] - problem->lower[i]));
  }
  return x;
}

TEST(ProblemFunctions, SayWhatTheStructureSays) {
  for (const char* const name :
       {"hs-71", "top-speed-C1", "least-squares-01-linear-full-rank-9x45"}) {
    SCOPED_TRACE(name);
    const Opened opened = open(name, "", 2);
    ASSERT_TRUE(opened) << ricochet_error();
    const ricochet_problem* const problem = opened.get();
    EXPECT_STREQ(ricochet_name(problem), name);
    EXPECT_EQ(ricochet_dimension(problem), problem->dimension);
    EXPECT_EQ(ricochet_constraints(problem), problem->constraints);
    EXPECT_EQ(ricochet_equalities(problem), problem->equalities);
    EXPECT_EQ(ricochet_has_derivatives(problem), problem->has_derivatives);
    EXPECT_EQ(ricochet_has_residuals(problem), problem->has_residuals);
    const auto size = static_cast<std::size_t>(problem->dimension);
    std::vector<double> lower(size), upper(size), start(size);
    EXPECT_EQ(ricochet_bounds(problem, lower.data(), upper.data()), 0);
    EXPECT_EQ(ricochet_start(problem, start.data()), 0);
    EXPECT_EQ(lower, std::vector<double>(problem->lower, problem->lower + size));
    EXPECT_EQ(upper, std::vector<double>(problem->upper, problem->upper + size));
    EXPECT_EQ(start, std::vector<double>(problem->start, problem->start + size));
    EXPECT_EQ(ricochet_bounds(problem, nullptr, nullptr), 0);
  }
}

TEST(ProblemFunctions, SayWhatTheProblemSays) {
  const Problem problem = problem_named("top-speed-C1", 3);
  const Opened opened = open("top-speed-C1", "", 3);
  EXPECT_EQ(ricochet_best_known(opened.get()), problem.best_known.value());
  EXPECT_EQ(ricochet_tolerance(opened.get()), problem.tolerance);
  EXPECT_EQ(ricochet_unit(opened.get()), problem.unit);
  EXPECT_EQ(problem.unit, "rad/s");
  EXPECT_EQ(ricochet_variable_name(opened.get(), 0), problem.variables.at(0).name);
  EXPECT_EQ(ricochet_variable_unit(opened.get(), 0), problem.variables.at(0).unit);
  EXPECT_EQ(ricochet_variable_name(opened.get(), 1), nullptr);
  EXPECT_STREQ(ricochet_error(), "variable 1: must be from 0 to 0");
  const Opened unnamed = open("hs-71");
  EXPECT_STREQ(ricochet_variable_name(unnamed.get(), 3), "");
}

TEST(ProblemFunctions, TellWhatThePointersTell) {
  for (const auto& [name, formulation] :
       {std::pair("hs-71", "original"), {"top-speed-C1", "surrogate"}}) {
    SCOPED_TRACE(name);
    const Opened one = open(name, formulation), other = open(name, formulation);
    const auto n = static_cast<std::size_t>(one->dimension);
    const auto m = static_cast<std::size_t>(one->constraints);
    std::vector<double> f(1), c(m), g(n), j(m * n), f2(1), c2(m), g2(n), j2(m * n);
    for (const double share : {0.2, 0.7}) {
      const std::vector<double> x = point(one.get(), share);
      ASSERT_EQ(ricochet_values(one.get(), x.data(), f.data(), c.data()), 0);
      ASSERT_EQ(other->values(other.get(), x.data(), f2.data(), c2.data()), 0);
      EXPECT_EQ(f, f2);
      EXPECT_EQ(c, c2);
      const int refused =
          ricochet_derivatives(one.get(), x.data(), f.data(), c.data(), g.data(), j.data());
      EXPECT_EQ(
          other->derivatives(other.get(), x.data(), f2.data(), c2.data(), g2.data(), j2.data()),
          refused);
      EXPECT_EQ(g, g2);
      EXPECT_EQ(j, j2);
      EXPECT_EQ(ricochet_remaining(one.get()), other->remaining(other.get()));
    }
    EXPECT_EQ(ricochet_uniform(one.get()), other->uniform(other.get()));
  }
}

TEST(ProblemFunctions, TellResiduals) {
  const char* const name = "least-squares-01-linear-full-rank-9x45";
  const Opened one = open(name), other = open(name);
  const std::vector<double> x = point(one.get(), 0.4);
  ASSERT_EQ(ricochet_residual_count(one.get(), x.data()), 45);
  std::vector<double> told(45), expected(45), rows(45 * 9), expected_rows(45 * 9);
  ASSERT_EQ(ricochet_residuals(one.get(), x.data(), told.data(), rows.data()), 0);
  ASSERT_EQ(other->residuals(other.get(), x.data(), expected.data(), expected_rows.data()), 0);
  EXPECT_EQ(told, expected);
  EXPECT_EQ(rows, expected_rows);
}

TEST(ProblemFunctions, TellABatchAsPointByPoint) {
  const Opened one = open("hs-71", "", 0, 5), other = open("hs-71");
  std::vector<double> points;
  for (int k = 0; k < 7; ++k) {
    for (const double x : point(one.get(), k / 8.0)) points.push_back(x);
  }
  std::vector<double> objectives(7, -1), constraints(14, -1);
  EXPECT_EQ(ricochet_values_batch(one.get(), points.data(), 3, objectives.data(), nullptr), 3);
  EXPECT_EQ(ricochet_remaining(one.get()), 2);
  EXPECT_EQ(ricochet_values_batch(one.get(), points.data() + 12, 4, objectives.data() + 3,
                                  constraints.data() + 6),
            2)
      << "as far as the budget goes";
  EXPECT_STREQ(ricochet_error(), "the run is over: its budget of 5 evaluations is spent");
  for (std::size_t k = 0; k < 5; ++k) {
    double objective = 0;
    std::array<double, 2> both{};
    ASSERT_EQ(other->values(other.get(), &points[4 * k], &objective, both.data()), 0);
    EXPECT_EQ(objectives[k], objective);
    if (k < 3) continue;
    EXPECT_EQ(constraints[2 * k], both[0]);
    EXPECT_EQ(constraints[2 * k + 1], both[1]);
  }
  EXPECT_EQ(objectives[5], -1);
  EXPECT_EQ(constraints[10], -1);
  EXPECT_EQ(ricochet_values_batch(other.get(), nullptr, 0, nullptr, nullptr), 0);
  EXPECT_EQ(ricochet_values_batch(other.get(), points.data(), -1, nullptr, nullptr), 0);
  EXPECT_EQ(ricochet_values_batch(other.get(), nullptr, 2, nullptr, nullptr), 0);
  EXPECT_STREQ(ricochet_error(), "the point asked for is NULL");
}

TEST(ProblemFunctions, RefuseWhatIsNotOpen) {
  ricochet_problem* const closed = ricochet_open("hs-71", "", 0, 1, 0);
  ricochet_close(closed);
  double x[4] = {1, 1, 1, 1}, told = 0;
  for (ricochet_problem* const problem : {closed, static_cast<ricochet_problem*>(nullptr)}) {
    EXPECT_EQ(ricochet_dimension(problem), -1);
    EXPECT_EQ(ricochet_constraints(problem), -1);
    EXPECT_EQ(ricochet_equalities(problem), -1);
    EXPECT_EQ(ricochet_has_derivatives(problem), -1);
    EXPECT_EQ(ricochet_has_residuals(problem), -1);
    EXPECT_EQ(ricochet_name(problem), nullptr);
    EXPECT_EQ(ricochet_bounds(problem, x, x), 1);
    EXPECT_EQ(ricochet_start(problem, x), 1);
    EXPECT_TRUE(std::isnan(ricochet_best_known(problem)));
    EXPECT_TRUE(std::isnan(ricochet_tolerance(problem)));
    EXPECT_EQ(ricochet_values(problem, x, &told, nullptr), 1);
    EXPECT_EQ(ricochet_values_batch(problem, x, 1, &told, nullptr), 0);
    EXPECT_EQ(ricochet_derivatives(problem, x, &told, nullptr, nullptr, nullptr), 1);
    EXPECT_EQ(ricochet_residual_count(problem, x), 0);
    EXPECT_EQ(ricochet_residuals(problem, x, &told, nullptr), 1);
    EXPECT_EQ(ricochet_remaining(problem), -1);
    EXPECT_TRUE(std::isnan(ricochet_uniform(problem)));
    EXPECT_STREQ(ricochet_error(), "the problem is not open");
  }
  EXPECT_THAT(x, Each(1.0));
}

}  // namespace
}  // namespace ricochet::interface
