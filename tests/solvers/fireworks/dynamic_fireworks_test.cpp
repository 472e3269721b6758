#include "solvers/fireworks/dynamic_fireworks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "tests/solvers/fireworks/asked_points.h"
#include "tests/support/problems.h"

namespace ricochet::fireworks {
namespace {

/// A plateau of 7 with a needle of -1e6 at the start, which gets 120 sparks and the others 6 each.
Problem needle() {
  return box_problem("needle", 2, -1000, 1000, 500,
                     [](const Vector& x) { return x[0] == 500 && x[1] == 500 ? -1e6 : 7.0; });
}

/// How far from the start those of these points are that come of it, at most.
double farthest(const std::vector<Vector>& asked, std::size_t from, std::size_t count) {
  double result = 0;
  for (std::size_t k = from; k < from + count; ++k) {
    result = std::max(result, (asked[k].array() - 500).abs().maxCoeff());
  }
  return result;
}

TEST(DynamicFireworks, LessenTheBestAmplitudeAsLongAsNothingIsBetter) {
  constexpr int generations = 40;
  constexpr std::size_t core = 120, all = 144;
  // No clones, and the best only once: it alone has the needle's worth.
  const Solver solver = dynamic_fireworks(
      "dynfwa",
      {.moved = Moved::all, .selection = {.others = Others::uniform, .replacement = false}});
  const auto evaluations = static_cast<std::int64_t>(5 + all * generations);
  const std::vector<Vector> asked = asked_points(needle(), solver, evaluations, 0);
  ASSERT_EQ(asked.size(), 5 + all * generations);
  double amplitude = 2000;
  for (std::size_t g = 0; g < generations; ++g) {
    if (amplitude < 500) {  // below that no spark leaves the box
      const double reach = farthest(asked, 5 + all * g, core);
      EXPECT_LE(reach, amplitude * (1 + 1e-12)) << g;
      EXPECT_GT(reach, 0.9 * amplitude) << g;
    }
    amplitude *= 0.9;
  }
}

TEST(DynamicFireworks, RaiseTheBestAmplitudeAsLongAsSomethingIsBetter) {
  // Every point is better than all before it.
  Problem problem = box_problem("falling", 1, -1000, 1000, 0, [](const Vector&) { return 0.0; });
  double value = 0;
  problem.evaluate = [&value](const Vector&) { return Values{value -= 1, {}}; };
  const std::vector<Vector> asked = asked_points(
      problem, dynamic_fireworks("dynfwa", {.steps = {.growth = 1, .decline = 1e-9}}), 3000, 0);
  const auto tail = std::minmax_element(
      asked.end() - 500, asked.end(), [](const Vector& a, const Vector& b) { return a[0] < b[0]; });
  EXPECT_GT((*tail.second)[0] - (*tail.first)[0], 1500) << "with any decline it would be next to 0";
}

TEST(DynamicFireworks, FindAShiftedOptimum) {
  for (const double centre : {0.0, 30.0, 70.0}) {
    const RunRecord record = run(sphere(10, centre), dynamic_fireworks("dynfwa"), {60000}, 1);
    EXPECT_LT(record.trace.back().true_values.objective, 1e-3) << centre;
  }
}

TEST(DynamicFireworks, RefuseOptionsThatMakeNoSense) {
  EXPECT_THROW(dynamic_fireworks("none", {.fireworks = 0}), std::invalid_argument);
  EXPECT_THROW(dynamic_fireworks("negative", {.amplitude = -1}), std::invalid_argument);
  EXPECT_THROW(dynamic_fireworks("few", {.counts = {.sparks = 5}}), std::invalid_argument);
  EXPECT_THROW(dynamic_fireworks("grows", {.steps = {1.2, 1.1}}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet::fireworks
