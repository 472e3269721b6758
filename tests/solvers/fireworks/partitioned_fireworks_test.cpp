#include "solvers/fireworks/partitioned_fireworks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "tests/solvers/fireworks/asked_points.h"
#include "tests/support/problems.h"

namespace ricochet::fireworks {
namespace {

TEST(PartitionedFireworks, ShareTheGapBetweenTheirSurfaces) {
  EXPECT_DOUBLE_EQ(fitted_radius(10, 4, 2, false), 1.5);  // a gap of 4, half of it to each
  EXPECT_DOUBLE_EQ(fitted_radius(10, 4, 2, true), 2);
  EXPECT_DOUBLE_EQ(fitted_radius(10, 8, 6, false), 0.75);  // an overlap
  EXPECT_DOUBLE_EQ(fitted_radius(100, 4, 2, true), 2);
  EXPECT_DOUBLE_EQ(fitted_radius(4, 4, 3, true), 0.5);
  EXPECT_DOUBLE_EQ(fitted_radius(4, 4, 10, true), -1.5);
}

TEST(PartitionedFireworks, ReachForEachOther) {
  // Which sparks are good is chance: only the other firework gives a direction.
  const Problem noise = box_problem("noise", 2, 0, 1, 0.5, [](const Vector& x) {
    return std::sin(1e7 * x[0]) + std::sin(1.3e7 * x[1]);
  });
  double along = 0, across = 0;
  for (int number = 1; number <= 20; ++number) {
    const std::vector<Vector> asked = asked_points(
        noise, partitioned_fireworks("fwassp", {.fireworks = 2}), 2 + 120 + 60, number);
    const Vector towards = (asked[1] - asked[0]).normalized();
    for (auto x = asked.begin() + 122; x != asked.end(); ++x) {
      const Vector step = *x - asked[0];
      if (step.norm() > 0.2) continue;  // redrawn
      const double length = step.dot(towards);
      along += length * length;
      across += step.squaredNorm() - length * length;
    }
  }
  EXPECT_GT(along, 1.6 * across);
}

TEST(PartitionedFireworks, FindAShiftedOptimum) {
  for (const double centre : {0.0, 30.0, 70.0}) {
    const RunRecord record = run(sphere(10, centre), partitioned_fireworks("fwassp"), {60000}, 1);
    EXPECT_LT(record.trace.back().true_values.objective, 1e-6) << centre;
  }
}

TEST(PartitionedFireworks, SearchAShiftedBoxAsTheBoxItself) {
  const auto valley = [](double shift) {
    return box_problem("valley", 2, shift - 8, shift + 8, shift + 2, [shift](const Vector& x) {
      const double a = x[0] - shift, b = x[1] - shift;
      return (a - 1) * (a - 1) + 100 * (b - a) * (b - a);
    });
  };
  const Solver solver = partitioned_fireworks("fwassp");
  const std::vector<Vector> here = asked_points(valley(0), solver, 3000);
  const std::vector<Vector> there = asked_points(valley(32), solver, 3000);
  ASSERT_EQ(here.size(), there.size());
  // The first generations, before rounding grows.
  for (std::size_t i = 0; i < 600; ++i) {
    EXPECT_LT((here[i] + Vector::Constant(2, 32) - there[i]).norm(), 1e-9) << i;
  }
}

TEST(PartitionedFireworks, TurnAlongAValley) {
  const Problem valley = box_problem("valley", 5, -100, 100, 40, [](const Vector& x) {
    double sum = x[0] * x[0];
    for (Eigen::Index k = 1; k < x.size(); ++k) sum += 1e4 * (x[k] - x[0]) * (x[k] - x[0]);
    return sum;
  });
  const RunRecord record = run(valley, partitioned_fireworks("fwassp"), {60000}, 1);
  EXPECT_LT(record.trace.back().true_values.objective, 1e-3);
}

TEST(PartitionedFireworks, BeginAnewWhereAllSparksAreTied) {
  const std::vector<Vector> asked =
      asked_points(plateau(1), partitioned_fireworks("fwassp", {.sparks = 10}), 5 + 50 + 5 + 50, 0);
  // Each of the five is drawn anew after its sparks, and they lie about it.
  for (std::size_t i = 0; i < 5; ++i) {
    const double at = asked[55 + i][0];
    const auto first = asked.begin() + static_cast<std::ptrdiff_t>(60 + 10 * i);
    const auto near = std::count_if(first, first + 10, [&](const Vector& x) {
      const Problem problem = plateau(1);
      return std::abs(x[0] - at) < 0.3 * (problem.upper[0] - problem.lower[0]);
    });
    EXPECT_GE(near, 6) << i;
  }
}

TEST(PartitionedFireworks, RefuseOptionsThatMakeNoSense) {
  EXPECT_THROW(partitioned_fireworks("none", {.fireworks = 0}), std::invalid_argument);
  EXPECT_THROW(partitioned_fireworks("none", {.sparks = 0}), std::invalid_argument);
  EXPECT_THROW(partitioned_fireworks("point", {.initial_scale = 0}), std::invalid_argument);
  EXPECT_THROW(partitioned_fireworks("hasty", {.patience = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet::fireworks
