#include "solvers/fireworks/fireworks.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <vector>

#include "ricochet/run.h"
#include "tests/solvers/fireworks/asked_points.h"
#include "tests/support/problems.h"

namespace ricochet::fireworks {
namespace {

FireworksOptions as_printed() {
  FireworksOptions options;
  options.counts.third_branch = ThirdBranch::as_printed;
  return options;
}

double end_of_sphere(const FireworksOptions& options, double centre, int number) {
  const RunRecord record =
      run(sphere(30, centre), fireworks("fireworks", options), {10000}, number);
  return record.trace.back().true_values.objective;
}

Problem wide_plateau(Eigen::Index n) {
  return box_problem("wide plateau", n, -1000, 1000, 500, [](const Vector&) { return 7.0; });
}

std::vector<Vector> asked_on_plateau(const FireworksOptions& options, std::int64_t evaluations,
                                     Eigen::Index n = 3) {
  return asked_points(wide_plateau(n), fireworks("fireworks", options), evaluations);
}

TEST(Fireworks, SetsOff40SparksRoundEachFireworkOnAPlateauThenGaussianOnes) {
  const Problem problem = wide_plateau(3);
  const std::vector<Vector> asked = asked_on_plateau(paper_options(), 210);
  ASSERT_EQ(asked.size(), 210U);
  for (std::size_t k = 5; k < 205; ++k) {
    const Vector offset = asked[k] - asked[(k - 5) / 40];
    EXPECT_LE(offset.cwiseAbs().maxCoeff(), 40);
    EXPECT_NE(offset[0], offset[1]) << "each coordinate has a draw of its own";
  }
  // A Gaussian spark is g times a firework, mapped. One coordinate that was not mapped tells g.
  const Box box(problem.lower, problem.upper);
  Random random;
  const auto multiple = [&](const Vector& spark, const Vector& x) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      Vector scaled = x * (spark[i] / x[i]);
      box.bring_back(scaled, Mapping::modulo, random);
      if ((scaled - spark).norm() < 1e-9) return true;
    }
    return false;
  };
  for (std::size_t k = 205; k < 210; ++k) {
    EXPECT_TRUE(std::any_of(asked.begin(), asked.begin() + 5,
                            [&](const Vector& x) { return multiple(asked[k], x); }));
  }
}

TEST(Fireworks, OfTheAuthorsMoveSomeCoordinatesByOneDraw) {
  const std::vector<Vector> asked = asked_on_plateau(authors_options(), 205);
  std::set<Eigen::Index> counts;
  for (std::size_t k = 5; k < 205; ++k) {
    const Vector offset = asked[k] - asked[(k - 5) / 40];
    const double draw = offset[0] != 0 ? offset[0] : offset[1] != 0 ? offset[1] : offset[2];
    counts.insert((offset.array() != 0).count());
    for (const double each : offset) {
      if (each != 0) {
        EXPECT_NEAR(each, draw, 1e-9);
      }
    }
  }
  EXPECT_THAT(counts, testing::ElementsAre(1, 2, 3));
}

TEST(Fireworks, InBoxWidthsFlyAsFarInEveryBox) {
  FireworksOptions options;
  options.amplitude = 0.05;
  options.amplitude_unit = AmplitudeUnit::box_widths;
  const std::vector<Vector> asked = asked_on_plateau(options, 205);
  double farthest = 0;
  for (std::size_t k = 5; k < 205; ++k) {
    const Vector offset = asked[k] - asked[(k - 5) / 40];
    for (Eigen::Index i = 0; i < 3; ++i) {  // those that are not mapped
      if (std::abs(asked[(k - 5) / 40][i]) < 900)
        farthest = std::max(farthest, std::abs(offset[i]));
    }
  }
  EXPECT_GT(farthest, 90);
  EXPECT_LE(farthest, 100);
}

TEST(Fireworks, KeepsTheBestOfEveryGeneration) {
  // The best firework's amplitude is next to nothing, so each generation of at most some 60 points
  // asks again for the best point before it.
  const Problem problem = sphere(2, 3);
  const std::vector<Vector> asked = asked_points(problem, fireworks("fireworks", {}), 2000);
  Vector best = asked.front();
  std::size_t last_clone = 0;
  for (std::size_t k = 1; k < asked.size(); ++k) {
    if ((asked[k] - best).norm() < 1e-9) last_clone = k;
    ASSERT_LT(k - last_clone, 130U) << "two generations without it";
    if (problem.evaluate(asked[k]).objective < problem.evaluate(best).objective) best = asked[k];
  }
}

TEST(Fireworks, AsPublishedFindAnOptimumAtTheOriginAndMissAShiftedOne) {
  for (const int number : {1, 2, 3}) {
    for (const FireworksOptions& options : {paper_options(), as_printed(), authors_options()}) {
      EXPECT_LT(end_of_sphere(options, 0, number), 1e-20);
      EXPECT_GT(end_of_sphere(options, 5, number), 1);
      EXPECT_GT(end_of_sphere(options, 30, number), 100);
    }
  }
}

TEST(Fireworks, EnhancedAndCorrectedFindAShiftedOptimumAsWell) {
  for (const int number : {1, 2, 3}) {
    for (const FireworksOptions& options : {enhanced_options(), corrected_options()}) {
      EXPECT_GT(end_of_sphere(options, 0, number), 1e-3);
      EXPECT_LT(end_of_sphere(options, 0, number), 300);
      EXPECT_LT(end_of_sphere(options, 30, number), 300);
    }
  }
}

TEST(Fireworks, CorrectedSpendNoMoreThanTheirSparksOnAPlateauAndNoneTwice) {
  const std::vector<Vector> asked = asked_on_plateau(corrected_options(), 5000, 1);
  std::set<double> different;
  for (const Vector& x : asked) different.insert(x[0]);
  EXPECT_EQ(different.size(), asked.size());
  // 50 explosion sparks of the first five fireworks, 10 each, fly 0.2 box smoothing parameters.
  for (std::size_t k = 5; k < 55; ++k) {
    const double offset = std::abs(asked[k][0] - asked[(k - 5) / 10][0]);
    const bool redrawn = std::abs(asked[(k - 5) / 10][0]) > 600;
    EXPECT_TRUE(redrawn || offset <= 400) << k;
  }
}

TEST(Fireworks, AsPublishedSpendHalfOfTheirSparksOnClonesWhereTheyRound) {
  FireworksOptions rounded = paper_options();
  rounded.moved = Moved::rounded;
  const std::vector<Vector> asked = asked_on_plateau(rounded, 205, 1);
  int clones = 0;
  for (std::size_t k = 5; k < 205; ++k) clones += asked[k] == asked[(k - 5) / 40] ? 1 : 0;
  EXPECT_NEAR(clones, 100, 30);
}

TEST(Fireworks, BeginInTheRegionTheyAreGiven) {
  FireworksOptions options;
  options.start_region = {30, 50};
  for (const Vector& x : asked_points(sphere(4, 0), fireworks("fireworks", options), 5)) {
    EXPECT_GE(x.minCoeff(), 30);
    EXPECT_LE(x.maxCoeff(), 50);
  }
}

TEST(Fireworks, RefuseOptionsThatMakeNoSense) {
  EXPECT_THROW(fireworks("none", {.fireworks = 0}), std::invalid_argument);
  EXPECT_THROW(fireworks("negative", {.amplitude = -1}), std::invalid_argument);
  EXPECT_THROW(fireworks("nan", {.amplitude = not_a_number}), std::invalid_argument);
  EXPECT_THROW(fireworks("few", {.counts = {.sparks = 5}}), std::invalid_argument);
  EXPECT_THROW(fireworks("rising", {.amplitude_floor = {0.1, 0.2}}), std::invalid_argument);
  EXPECT_THROW(fireworks("minus", {.gaussian_sparks = -1}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet::fireworks
