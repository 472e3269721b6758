#include "solvers/fireworks/fireworks.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

#include "src/core/run.h"
#include "tests/solvers/test_problems.h"

namespace ricochet {
namespace {

using testing::ElementsAre;

constexpr double infinity = std::numeric_limits<double>::infinity();
const FireworksOptions as_printed = {.third_branch = ThirdBranch::as_printed};

/// Every point that fireworks asks for, in order.
std::vector<Vector> asked_points(const Problem& problem, std::int64_t evaluations) {
  std::vector<Vector> asked;
  Problem recorded = problem;
  recorded.evaluate = [&](const Vector& x) {
    asked.push_back(x);
    return problem.evaluate(x);
  };
  run(recorded, fireworks("fireworks", {}), {evaluations}, 1);
  return asked;
}

double end_of_sphere(const FireworksOptions& options, double centre, int number) {
  const RunRecord record =
      run(sphere(30, centre), fireworks("fireworks", options), {10000}, number);
  return record.trace.back().truth.objective;
}

TEST(SparkCounts, ShareTheSparksByQuality) {
  // Excesses over the worst 4 3 2 1 0 of 10: shares 20, 15, 10, 5 and about 0 of 50.
  EXPECT_THAT(spark_counts(Vector{{0, 1, 2, 3, 4}}, {}), ElementsAre(20, 15, 10, 5, 2));
  EXPECT_THAT(spark_counts(Vector{{7, 7, 7, 7, 8}}, {}), ElementsAre(13, 13, 13, 13, 2));
}

TEST(SparkCounts, AreLimitedAtBothEnds) {
  EXPECT_THAT(spark_counts(Vector{{0, 10, 10, 10, 10}}, {}), ElementsAre(40, 2, 2, 2, 2));
}

TEST(SparkCounts, AreAllTheMostWhereAllAreTied) {
  EXPECT_THAT(spark_counts(Vector::Constant(5, 7), {}), ElementsAre(40, 40, 40, 40, 40));
  EXPECT_THAT(spark_counts(Vector::Constant(5, 7), as_printed), ElementsAre(40, 40, 40, 40, 40));
}

TEST(SparkCounts, AsPrintedAreTheFewestBelowTheMost) {
  EXPECT_THAT(spark_counts(Vector{{0, 1, 2, 3, 4}}, as_printed), ElementsAre(2, 2, 2, 2, 2));
  EXPECT_THAT(spark_counts(Vector{{0, 10, 10, 10, 10}}, as_printed), ElementsAre(40, 2, 2, 2, 2));
}

TEST(SparkCounts, TakeWhatIsNotUsableForTheWorst) {
  for (const double bad : {not_a_number, infinity, -infinity, 1e305}) {
    EXPECT_THAT(spark_counts(Vector{{0, 1, 2, 3, bad}}, {}), ElementsAre(25, 17, 8, 2, 2));
    EXPECT_THAT(spark_counts(Vector::Constant(2, bad), {}), ElementsAre(40, 40));
  }
}

TEST(Amplitudes, GrowWithTheDistanceToTheBest) {
  const Vector spread = amplitudes(Vector{{0, 1, 2, 3, 4}}, {});
  EXPECT_LT((spread - Vector{{0, 4, 8, 12, 16}}).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Amplitudes, LeaveTheBestNextToNothing) {
  const Vector tied_but_one = amplitudes(Vector{{7, 7, 7, 7, 8}}, {});
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(tied_but_one[i], 40 * 2.2e-16, 1e-18);
  EXPECT_NEAR(tied_but_one[4], 40, 1e-12);
}

TEST(Amplitudes, AreAllTheWholeWhereAllAreTied) {
  EXPECT_EQ(amplitudes(Vector::Constant(5, 7), {}), Vector::Constant(5, 40));
}

TEST(Mapped, BringsBackOnlyWhatIsOutside) {
  const auto one = [](double x, double lower, double upper) {
    return mapped(Vector::Constant(1, x), Vector::Constant(1, lower),
                  Vector::Constant(1, upper))[0];
  };
  EXPECT_EQ(one(-3, -100, 100), -3);
  EXPECT_EQ(one(-100, -100, 100), -100);
  EXPECT_EQ(one(100, -100, 100), 100);
  EXPECT_EQ(one(130, -100, 100), 30);
  EXPECT_EQ(one(-130, -100, 100), 30);
  EXPECT_EQ(one(18.5, 0, 18), 0.5);
  EXPECT_EQ(one(-0.5, 0, 18), 0.5);
  EXPECT_EQ(one(-7, 2, 10), 9);
  EXPECT_EQ(one(5, 4, 4), 4);
}

TEST(RouletteWeights, AreSumsOfDistances) {
  EXPECT_THAT(roulette_weights(Matrix{{0, 1, 3}}), ElementsAre(4, 3, 5));
  EXPECT_THAT(roulette_weights(Matrix{{0, 3}, {0, 4}}), ElementsAre(5, 5));
}

TEST(RouletteWeights, AreEqualWhereAllPointsCoincide) {
  EXPECT_THAT(roulette_weights(Matrix::Constant(2, 3, 7)), ElementsAre(1, 1, 1));
}

TEST(Fireworks, SetsOff40SparksRoundEachFireworkOnAPlateauThenGaussianOnes) {
  const Problem problem =
      box_problem("wide plateau", 3, -1000, 1000, 500, [](const Vector&) { return 7.0; });
  const std::vector<Vector> asked = asked_points(problem, 210);
  ASSERT_EQ(asked.size(), 210U);
  for (std::size_t k = 5; k < 205; ++k) {
    const Vector offset = asked[k] - asked[(k - 5) / 40];
    EXPECT_LE(offset.cwiseAbs().maxCoeff(), 40);
    EXPECT_NE(offset[0], offset[1]) << "each coordinate has a draw of its own";
  }
  // A Gaussian spark is g times a firework, mapped. One coordinate that was not mapped tells g.
  const auto multiple = [&](const Vector& spark, const Vector& x) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Vector scaled = mapped(x * (spark[i] / x[i]), problem.lower, problem.upper);
      if ((scaled - spark).norm() < 1e-9) return true;
    }
    return false;
  };
  for (std::size_t k = 205; k < 210; ++k) {
    EXPECT_TRUE(std::any_of(asked.begin(), asked.begin() + 5,
                            [&](const Vector& x) { return multiple(asked[k], x); }));
  }
}

TEST(Fireworks, KeepsTheBestOfEveryGeneration) {
  // The best firework's amplitude is next to nothing, so each generation of at most some 60 points
  // asks again for the best point before it.
  const Problem problem = sphere(2, 3);
  const std::vector<Vector> asked = asked_points(problem, 2000);
  Vector best = asked.front();
  std::size_t last_clone = 0;
  for (std::size_t k = 1; k < asked.size(); ++k) {
    if ((asked[k] - best).norm() < 1e-9) last_clone = k;
    ASSERT_LT(k - last_clone, 130U) << "two generations without it";
    if (problem.evaluate(asked[k]).objective < problem.evaluate(best).objective) best = asked[k];
  }
}

TEST(Fireworks, FindsAnOptimumAtTheOriginAndMissesAShiftedOne) {
  for (const int number : {1, 2, 3}) {
    EXPECT_LT(end_of_sphere({}, 0, number), 1e-20);
    EXPECT_GT(end_of_sphere({}, 5, number), 1);
    EXPECT_GT(end_of_sphere({}, 30, number), 1000);
    EXPECT_LT(end_of_sphere(as_printed, 0, number), 1e-20);
    EXPECT_GT(end_of_sphere(as_printed, 30, number), 1000);
  }
}

TEST(Fireworks, RefusesOptionsThatMakeNoSense) {
  EXPECT_THROW(fireworks("none", {.fireworks = 0}), std::invalid_argument);
  EXPECT_THROW(fireworks("negative", {.amplitude = -1}), std::invalid_argument);
  EXPECT_THROW(fireworks("nan", {.amplitude = not_a_number}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
