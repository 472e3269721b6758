#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "solvers/library_solvers.h"
#include "src/studies/fireworks/study.h"

namespace ricochet::studies::fireworks {
namespace {

TEST(Moments, AreTheMeanAndTheDeviationOfASample) {
  const Moments moments = moments_of({1, 2, 3, 4, 5});
  EXPECT_DOUBLE_EQ(moments.mean, 3);
  EXPECT_DOUBLE_EQ(moments.deviation, std::sqrt(2.5));
  EXPECT_EQ(moments.runs, 5U);
}

TEST(Moments, AgreeWithWhatChanceWouldBring) {
  const Moments moments = moments_of({1, 2, 3, 4, 5});
  // t of 4 degrees, from tables
  const double reach = 2.7764451 * std::sqrt(2.5 * (1.0 / 5 + 1.0 / 10));
  EXPECT_TRUE(agrees(moments, {3 + 0.999 * reach, 10}));
  EXPECT_FALSE(agrees(moments, {3 + 1.001 * reach, 10}));
  EXPECT_FALSE(agrees(moments, {3 - 1.001 * reach, 10}));
  const double own = 2.7764451 * std::sqrt(2.5 / 5);  // another that is exact
  EXPECT_TRUE(agrees(moments, {3 + 0.999 * own, 10, 0}));
  EXPECT_FALSE(agrees(moments, {3 + 1.001 * own, 10, 0}));
  EXPECT_TRUE(agrees(moments_of({0, 0, 0}), {1e-14, 15})) << "both are zero";
}

TEST(Errors, AreThoseOfTheRunsNumberedFromOne) {
  const Problem problem = shifted_sphere(7, 2);
  const auto errors = errors_of(
      {{random_search(), [&] { return problem; }}, {random_search(), [&] { return problem; }}}, 50,
      3, "test");
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_EQ(errors[0], errors[1]);
  for (int number = 1; number <= 3; ++number) {
    const RunRecord record = run(problem, random_search(), {50}, number);
    EXPECT_EQ(errors[0].at(static_cast<std::size_t>(number - 1)),
              record.trace.back().true_values.objective);
  }
}

TEST(Errors, TellOfAProblemThatFails) {
  Problem problem = shifted_sphere(7, 2);
  problem.evaluate = [](const Vector&) -> Values { throw std::runtime_error("broken"); };
  EXPECT_THROW(errors_of({{random_search(), [&] { return problem; }}}, 50, 1, "test"),
               std::runtime_error);
}

}  // namespace
}  // namespace ricochet::studies::fireworks
