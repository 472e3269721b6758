#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "solvers/fireworks/dynamic_fireworks.h"
#include "tests/solvers/fireworks/asked_points.h"
#include "tests/support/problems.h"

namespace ricochet::fireworks {
namespace {

constexpr std::size_t sparks = 300;

/// How far from `centre` the points of generation g are, at most.
double reach(const std::vector<Vector>& asked, std::size_t g, double centre) {
  double result = 0;
  for (std::size_t k = 1 + sparks * g; k < 1 + sparks * (g + 1); ++k) {
    result = std::max(result, (asked[k].array() - centre).abs().maxCoeff());
  }
  return result;
}

TEST(BareBonesFireworks, ShrinkTheirBoxOnAPlateauAndStay) {
  const Problem problem =
      box_problem("plateau", 2, -1000, 1000, 100, [](const Vector&) { return 7.0; });
  const std::vector<Vector> asked =
      asked_points(problem, bare_bones_fireworks("bbfwa"), 1 + sparks * 40, 0);
  double amplitude = 2000;
  for (std::size_t g = 0; g < 40; ++g) {
    if (amplitude < 900) {  // below that no spark leaves the box
      EXPECT_LE(reach(asked, g, 100), amplitude * (1 + 1e-12)) << g;
      EXPECT_GT(reach(asked, g, 100), 0.95 * amplitude) << g;
    }
    amplitude *= 0.9;
  }
}

TEST(BareBonesFireworks, MoveAlongAPlateauOnlyIfSoDecided) {
  const Problem problem =
      box_problem("plateau", 1, -1000, 1000, 100, [](const Vector&) { return 7.0; });
  for (const bool neutral_moves : {false, true}) {
    const std::vector<Vector> asked =
        asked_points(problem, bare_bones_fireworks("bbfwa", {.neutral_moves = neutral_moves}),
                     1 + sparks * 60, 0);
    double middle = 0;  // of the last generation, which is some 2000 * 0.9^59 = 4 wide to each side
    for (std::size_t k = asked.size() - sparks; k < asked.size(); ++k)
      middle += asked[k][0] / sparks;
    EXPECT_EQ(std::abs(middle - 100) > 4, neutral_moves);
  }
}

TEST(BareBonesFireworks, FindAShiftedOptimum) {
  for (const double centre : {0.0, 30.0, 70.0}) {
    const RunRecord record = run(sphere(3, centre), bare_bones_fireworks("bbfwa"), {60000}, 1);
    EXPECT_LT(record.trace.back().true_values.objective, 1e-6) << centre;
  }
}

TEST(BareBonesFireworks, RefuseOptionsThatMakeNoSense) {
  EXPECT_THROW(bare_bones_fireworks("none", {.sparks = 0}), std::invalid_argument);
  EXPECT_THROW(bare_bones_fireworks("grows", {.steps = {1.2, 1.1}}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet::fireworks
