#include <gmock/gmock.h>

#include <numeric>
#include <stdexcept>

#include "ricochet/random.h"
#include "solvers/fireworks/sparks.h"

namespace ricochet::fireworks {
namespace {

using testing::ElementsAre;

const SparkCountOptions as_printed = {.third_branch = ThirdBranch::as_printed};

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

TEST(SparkCounts, AreEqualPartsWhereAllAreTiedIfSoDecided) {
  EXPECT_THAT(spark_counts(Vector::Constant(5, 7), {.tied = TiedShare::equal}),
              ElementsAre(10, 10, 10, 10, 10));
  EXPECT_THAT(spark_counts(Vector{{7, 7, 7, 7, 8}}, {.tied = TiedShare::equal}),
              ElementsAre(13, 13, 13, 13, 2));
}

TEST(SparkCounts, AsPrintedAreTheFewestBelowTheMost) {
  EXPECT_THAT(spark_counts(Vector{{0, 1, 2, 3, 4}}, as_printed), ElementsAre(2, 2, 2, 2, 2));
  EXPECT_THAT(spark_counts(Vector{{0, 10, 10, 10, 10}}, as_printed), ElementsAre(40, 2, 2, 2, 2));
}

TEST(SparkCounts, StayWithinTheirLimitsAndFollowTheFitness) {
  Random random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    const SparkCountOptions options = {
        .sparks = std::floor(20 + 200 * uniform(random)),
        .tied = uniform(random) < 0.5 ? TiedShare::most : TiedShare::equal};
    const Vector fitness = (3 * normal(5, random)).array().floor();
    const std::vector<int> counts = spark_counts(fitness, options);
    for (std::size_t i = 0; i < 5; ++i) {
      ASSERT_GE(counts[i], std::round(options.fewest * options.sparks));
      ASSERT_LE(counts[i], std::round(options.most * options.sparks));
      for (std::size_t j = 0; j < 5; ++j) {
        if (fitness[static_cast<Eigen::Index>(i)] <= fitness[static_cast<Eigen::Index>(j)]) {
          ASSERT_GE(counts[i], counts[j]);
        }
      }
    }
    ASSERT_LE(std::accumulate(counts.begin(), counts.end(), 0), most_sparks(5, options));
  }
}

TEST(SparkCounts, AreRefusedWhereAFireworkMightHaveNone) {
  EXPECT_THROW(check(SparkCountOptions{.sparks = 5}), std::invalid_argument);
  EXPECT_THROW(check(SparkCountOptions{.fewest = 0.9}), std::invalid_argument);
  EXPECT_THROW(check(SparkCountOptions{.most = 1}), std::invalid_argument);
  EXPECT_THROW(check(SparkCountOptions{.sparks = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(check(SparkCountOptions{.epsilon = 0}), std::invalid_argument);
  EXPECT_NO_THROW(check(SparkCountOptions{}));
}

}  // namespace
}  // namespace ricochet::fireworks
