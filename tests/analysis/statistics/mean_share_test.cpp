#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

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

TEST(MeanShare, RefusesWhatDoesNotFit) {
  EXPECT_THROW(mean_share({}), std::invalid_argument);
  EXPECT_THROW(mean_share({0.5, 1.1}), std::invalid_argument);
  EXPECT_THROW(mean_share({std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
