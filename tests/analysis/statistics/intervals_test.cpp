#include "src/analysis/statistics/intervals.h"

#include "ricochet/random.h"
#include "tests/support/numbers.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

using testing::DoubleNear;

TEST(WilsonInterval, IsAsPublished) {
  struct Published {
    double successes, trials, lower, upper;
  };
  // Newcombe 1998, Statistics in Medicine 17, 857, table I, method 3: four digits.
  for (const auto& [successes, trials, lower, upper] : {Published{81, 263, 0.2553, 0.3662},
                                                        {15, 148, 0.0624, 0.1605},
                                                        {0, 20, 0, 0.1611},
                                                        {1, 29, 0.0061, 0.1718}}) {
    EXPECT_THAT(wilson_interval(successes, trials),
                FieldsAre(DoubleNear(lower, 5e-5), DoubleNear(upper, 5e-5)));
  }
}

TEST(WilsonInterval, EndsWhereTheShareIsJustCompatible) {
  const double z = 1.6448536269514722;  // of the normal distribution at 0.95
  for (int trials = 1; trials < 60; ++trials) {
    for (int successes = 0; successes <= trials; ++successes) {
      const Interval interval = wilson_interval(successes, trials, 0.9);
      const double share = static_cast<double>(successes) / trials;
      for (const double p : {interval.lower, interval.upper}) {
        if (p == share) continue;  // 0 and 1 themselves
        EXPECT_NEAR(std::abs(share - p), z * std::sqrt(p * (1 - p) / trials), 1e-12);
      }
      EXPECT_LE(interval.lower, share);
      EXPECT_GE(interval.upper, share);
    }
  }
}

TEST(MeanShare, IsWilsonsWhereSharesAreAllOrNothing) {
  for (const int ones : {0, 3, 20}) {
    std::vector<double> shares(20, 0.0);
    std::fill_n(shares.begin(), ones, 1);
    const Interval wilson = wilson_interval(ones, 20);
    EXPECT_THAT(mean_share(shares),
                FieldsAre(ones / 20.0, FieldsAre(DoubleNear(wilson.lower, 0.002),
                                                 DoubleNear(wilson.upper, 0.002))));
  }
}

TEST(MeanShare, IsStudentsWhereSharesAreManyAndInTheMiddle) {
  Random random(8);
  std::vector<double> shares(1000);
  for (double& share : shares) share = 0.4 + 0.2 * uniform(random);
  const Eigen::Map<const Eigen::ArrayXd> all(shares.data(), 1000);
  const double mean = all.mean(), half = 1.96 * std::sqrt((all - mean).square().mean() / 1000);
  EXPECT_THAT(mean_share(shares),
              FieldsAre(DoubleNear(mean, 1e-12), FieldsAre(DoubleNear(mean - half, 0.02 * half),
                                                           DoubleNear(mean + half, 0.02 * half))));
}

TEST(MeanShare, HoldsItsMeanWithin0And1AndIsAlikeForTheRest) {
  Random random(9);
  for (int i = 0; i < 200; ++i) {
    std::vector<double> shares(1 + random() % 8);
    for (double& share : shares) share = std::pow(uniform(random), 8);
    const MeanShare share = mean_share(shares);
    EXPECT_GE(share.interval.lower, 0);
    EXPECT_LT(share.interval.lower, share.mean);
    EXPECT_GT(share.interval.upper, share.mean);
    EXPECT_LE(share.interval.upper, 1);
    for (double& rest : shares) rest = 1 - rest;
    EXPECT_NEAR(mean_share(shares).interval.lower, 1 - share.interval.upper, 1e-9);
  }
}

TEST(MeanShare, CountsProblemsThatAreEqualInTheirClusterOnce) {
  // Each cluster repeats one share, so that the mean varies as that of the clusters alone.
  const std::vector<double> single = {0, 0.2, 0.4, 0.5, 0.5, 0.6, 0.8, 1, 0.1, 0.9, 0.7, 0.3};
  std::vector<double> shares;
  std::vector<std::string> own, clusters;
  for (const double share : single) {
    own.push_back(std::to_string(own.size()));
    shares.insert(shares.end(), 5, share);
    clusters.insert(clusters.end(), 5, own.back());
  }
  const auto width = [](const MeanShare& share) {
    return share.interval.upper - share.interval.lower;
  };
  const MeanShare once = mean_share(single), all = mean_share(shares, clusters);
  const double student = 2.201 / 1.960;  // quantiles .975 of t with 11 degrees of freedom, normal
  EXPECT_NEAR(all.mean, once.mean, 1e-12);
  EXPECT_NEAR(width(all), student * width(once), 0.02 * width(once));
  EXPECT_LT(width(mean_share(shares)), 0.5 * width(once));
  EXPECT_NEAR(effective_problems({shares}, clusters), 60 * 11.0 / 59, 1e-9);
  EXPECT_EQ(effective_problems({single}, own), 12) << "each is alone in its cluster";
}

TEST(Quantile, InterpolatesBetweenNeighboursWithInfiniteValuesLast) {
  for (const double share : {0.0, 0.25, 0.5, 1.0}) {
    EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, share), 1 + 3 * share);
  }
  EXPECT_EQ(quantile({1, infinity, 2}, 0.5), 2.0);
  EXPECT_EQ(quantile({1, infinity, infinity}, 0.5), infinity);
  EXPECT_EQ(quantile({infinity, infinity}, 0.3), infinity);
}

TEST(Bootstrap, OfARootMeanSquareHasTheQuantilesOfAllResamples) {
  // Of two errors 0 and 1 a sample has none, one or two of the second: 1/4, 1/2, 1/4.
  const std::vector<std::vector<double>> errors = {{0}, {-1}};
  EXPECT_DOUBLE_EQ(root_mean_square({3, -4}), std::sqrt(12.5));
  const auto interval = [](const std::vector<std::vector<double>>& groups, double confidence) {
    return root_mean_square_interval(groups, confidence, 10000, 1);
  };
  const auto half = testing::DoubleEq(std::sqrt(0.5));
  EXPECT_THAT(interval(errors, 0.4), FieldsAre(half, half));
  EXPECT_THAT(interval(errors, 0.95), FieldsAre(0, 1));
  // Errors of a group come together: a quarter of the samples has only the first group.
  EXPECT_DOUBLE_EQ(interval({{0, 0}, {2, 2}}, 0.4).lower, std::sqrt(2));
  EXPECT_DOUBLE_EQ(interval({{0, 0, 0}, {2}}, 0.4).lower, 1);
}

TEST(Intervals, RefuseWhatDoesNotFit) {
  EXPECT_THROW(wilson_interval(0, 0), std::invalid_argument);
  EXPECT_THROW(wilson_interval(3, 2), std::invalid_argument);
  EXPECT_THROW(wilson_interval(-1, 2), std::invalid_argument);
  EXPECT_THROW(wilson_interval(1, 2, 1.0), std::invalid_argument);
  EXPECT_THROW(mean_share({}), std::invalid_argument);
  EXPECT_THROW(mean_share({0.5, 1.1}), std::invalid_argument);
  EXPECT_THROW(mean_share({std::nan("")}), std::invalid_argument);
  EXPECT_THROW(mean_share({0.5, 0.6}, {"a"}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
