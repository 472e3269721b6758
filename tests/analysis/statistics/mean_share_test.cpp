#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "ricochet/random.h"
#include "src/analysis/statistics/intervals.h"

namespace ricochet {
namespace {

TEST(MeanShare, IsWilsonsWhereSharesAreAllOrNothing) {
  for (const int ones : {0, 3, 20}) {
    std::vector<double> shares(20, 0.0);
    for (int k = 0; k < ones; ++k) shares[static_cast<std::size_t>(k)] = 1;
    const MeanShare share = mean_share(shares);
    EXPECT_EQ(share.mean, ones / 20.0);
    EXPECT_NEAR(share.interval.lower, wilson_interval(ones, 20).lower, 0.002);
    EXPECT_NEAR(share.interval.upper, wilson_interval(ones, 20).upper, 0.002);
  }
}

TEST(MeanShare, IsStudentsWhereSharesAreManyAndInTheMiddle) {
  Random random(8);
  std::vector<double> shares;
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < 1000; ++i) {
    shares.push_back(0.4 + 0.2 * uniform(random));
    sum += shares.back();
    squares += shares.back() * shares.back();
  }
  const double half = 1.96 * std::sqrt((squares / 1000 - std::pow(sum / 1000, 2)) / 1000);
  const MeanShare share = mean_share(shares);
  EXPECT_NEAR(share.mean, sum / 1000, 1e-12);
  EXPECT_NEAR(share.interval.lower, sum / 1000 - half, 0.02 * half);
  EXPECT_NEAR(share.interval.upper, sum / 1000 + half, 0.02 * half);
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
  std::vector<std::string> clusters;
  for (std::size_t k = 0; k < single.size(); ++k) {
    for (int copy = 0; copy < 5; ++copy) {
      shares.push_back(single[k]);
      clusters.push_back(std::to_string(k));
    }
  }
  const MeanShare once = mean_share(single);
  const MeanShare all = mean_share(shares, clusters);
  const double width = once.interval.upper - once.interval.lower;
  const double student = 2.201 / 1.960;  // quantiles .975 of t with 11 degrees of freedom, normal
  EXPECT_NEAR(all.mean, once.mean, 1e-12);
  EXPECT_NEAR(all.interval.upper - all.interval.lower, student * width, 0.02 * width);
  EXPECT_LT(mean_share(shares).interval.upper - mean_share(shares).interval.lower, 0.5 * width);
  EXPECT_NEAR(effective_problems({shares}, clusters), 60 * 11.0 / 59, 1e-9);
  std::vector<std::string> own;
  for (std::size_t k = 0; k < single.size(); ++k) own.push_back(std::to_string(k));
  EXPECT_EQ(effective_problems({single}, own), 12) << "each is alone in its cluster";
}

TEST(MeanShare, RefusesWhatDoesNotFit) {
  EXPECT_THROW(mean_share({}), std::invalid_argument);
  EXPECT_THROW(mean_share({0.5, 1.1}), std::invalid_argument);
  EXPECT_THROW(mean_share({std::nan("")}), std::invalid_argument);
  EXPECT_THROW(mean_share({0.5, 0.6}, {"a"}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
