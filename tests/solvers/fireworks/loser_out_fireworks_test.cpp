#include "solvers/fireworks/loser_out_fireworks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "tests/solvers/fireworks/asked_points.h"
#include "tests/support/problems.h"

namespace ricochet::fireworks {
namespace {

TEST(LoserOutFireworks, LoseWhereTheyGetBetterTooSlowly) {
  EXPECT_TRUE(loses(10, 9, 0, 8));    // 8 more at best, of 9
  EXPECT_FALSE(loses(10, 9, 0, 9));   // just enough
  EXPECT_FALSE(loses(10, 10, 0, 8));  // who stands still is not judged
  EXPECT_FALSE(loses(10, 9, 9, 0));   // the best never loses
}

TEST(LoserOutFireworks, GuideTheLastSparkOfEachFirework) {
  const Problem problem = box_problem("slope", 2, -1000, 1000, 0, [](const Vector& x) {
    return x[0];  // no two of its sparks are tied
  });
  const std::vector<Vector> asked =
      asked_points(problem, loser_out_fireworks("lotfwa"), 5 + 5 * 61, 0);
  int inside = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    const auto first = asked.begin() + static_cast<std::ptrdiff_t>(5 + 61 * i);
    std::vector<Vector> sparks(first, first + 60);
    std::sort(sparks.begin(), sparks.end(),
              [](const Vector& a, const Vector& b) { return a[0] < b[0]; });
    const Vector zero = Vector::Zero(2);
    const Vector best = std::accumulate(sparks.begin(), sparks.begin() + 12, zero) / 12;
    const Vector worst = std::accumulate(sparks.end() - 12, sparks.end(), zero) / 12;
    const Vector guided = asked[i] + best - worst;
    for (Eigen::Index k = 0; k < 2; ++k) {
      if (std::abs(guided[k]) > 1000) continue;  // redrawn
      ++inside;
      EXPECT_NEAR((*(first + 60))[k], guided[k], 1e-9);
    }
  }
  EXPECT_GE(inside, 5);
}

TEST(LoserOutFireworks, FindAShiftedOptimum) {
  for (const double centre : {0.0, 30.0, 70.0}) {
    const RunRecord record = run(sphere(10, centre), loser_out_fireworks("lotfwa"), {60000}, 1);
    EXPECT_LT(record.trace.back().true_values.objective, 1e-2) << centre;
  }
}

TEST(LoserOutFireworks, BeginAnewWhereTheyLose) {
  // Every point is a little better than all before it, but the first guiding spark, the 66th point,
  // is much better: the four other fireworks lose, and are drawn and evaluated anew before the
  // second generation.
  Problem problem = box_problem("falling", 6, -1000, 1000, 0, [](const Vector&) { return 0.0; });
  int call = 0;
  problem.evaluate = [&call](const Vector&) {
    ++call;
    return Values{call == 66 ? -1e6 : -1e-3 * call, {}};
  };
  const std::vector<Vector> asked = asked_points(problem, loser_out_fireworks("lotfwa"), 400, 0);
  const auto second = asked.begin() + 5 + 5 * 61 + 4;  // later sparks are better
  const Vector zero = Vector::Zero(6);
  const Vector guided = asked[65] + std::accumulate(second + 48, second + 60, zero) / 12 -
                        std::accumulate(second, second + 12, zero) / 12;
  int inside = 0;
  for (Eigen::Index k = 0; k < 6; ++k) {
    if (std::abs(guided[k]) > 1000) continue;  // redrawn
    ++inside;
    EXPECT_NEAR((*(second + 60))[k], guided[k], 1e-9);
  }
  EXPECT_GE(inside, 3);
}

TEST(LoserOutFireworks, GuideSeveralSparksBeyondTheMeanOfTheBest) {
  const Problem problem =
      box_problem("slope", 2, -1000, 1000, 0, [](const Vector& x) { return std::abs(x[0]); });
  const std::vector<Vector> asked =
      asked_points(problem, loser_out_fireworks("mgfwa", multi_guiding_options()), 5 + 5 * 70, 0);
  int inside = 0;
  double least = 2, most = -1;
  for (std::size_t i = 0; i < 5; ++i) {
    const auto first = asked.begin() + static_cast<std::ptrdiff_t>(5 + 70 * i);
    std::vector<Vector> sparks(first, first + 60);
    std::sort(sparks.begin(), sparks.end(),
              [](const Vector& a, const Vector& b) { return std::abs(a[0]) < std::abs(b[0]); });
    const Vector zero = Vector::Zero(2);
    const Vector best = std::accumulate(sparks.begin(), sparks.begin() + 12, zero) / 12;
    const Vector worst = std::accumulate(sparks.end() - 12, sparks.end(), zero) / 12;
    for (auto spark = first + 60; spark != first + 70; ++spark) {
      const double times = ((*spark)[1] - best[1]) / (best[1] - worst[1]);
      const double off = (*spark)[0] - best[0] - times * (best[0] - worst[0]);
      if (std::abs(off) > 1e-6) continue;  // redrawn
      ++inside;
      least = std::min(least, times);
      most = std::max(most, times);
    }
  }
  EXPECT_GE(inside, 10);
  EXPECT_GE(least, 0);
  EXPECT_LE(most, 1.5);
  EXPECT_GT(most - least, 0.3);
}

TEST(LoserOutFireworks, OfSeveralGuidingSparksFindAShiftedOptimum) {
  for (const double centre : {0.0, 30.0, 70.0}) {
    const RunRecord record =
        run(sphere(10, centre), loser_out_fireworks("mgfwa", multi_guiding_options()), {60000}, 1);
    EXPECT_LT(record.trace.back().true_values.objective, 1e-2) << centre;
  }
}

TEST(LoserOutFireworks, RefuseOptionsThatMakeNoSense) {
  EXPECT_THROW(loser_out_fireworks("none", {.fireworks = 0}), std::invalid_argument);
  EXPECT_THROW(loser_out_fireworks("none", {.sparks = 0}), std::invalid_argument);
  EXPECT_THROW(loser_out_fireworks("all", {.guiding_share = 1.5}), std::invalid_argument);
  EXPECT_THROW(loser_out_fireworks("none", {.guiding_sparks = 0}), std::invalid_argument);
  EXPECT_THROW(loser_out_fireworks("back", {.reach = -1}), std::invalid_argument);
  EXPECT_THROW(loser_out_fireworks("grows", {.steps = {1.2, 1.1}}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet::fireworks
