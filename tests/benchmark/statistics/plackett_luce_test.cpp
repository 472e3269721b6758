#include "src/benchmark/statistics/plackett_luce.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <stdexcept>

namespace ricochet {
namespace {

constexpr double tolerance = 0.015;  // five deviations of the sampler, about

std::vector<Ranking> repeated(const Ranking& ranking, int times) {
  return std::vector<Ranking>(static_cast<std::size_t>(times), ranking);
}

std::vector<Ranking> operator+(std::vector<Ranking> a, const std::vector<Ranking>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(PlackettLuce, IsABetaDistributionOfTwoSolvers) {
  const auto strengths = plackett_luce(repeated({{0}, {1}}, 7) + repeated({{1}, {0}}, 3), 2, 1);
  const boost::math::beta_distribution<> posterior(8, 4);
  EXPECT_NEAR(strengths[0].weight, mean(posterior), tolerance);
  EXPECT_NEAR(strengths[0].weight_interval.lower, quantile(posterior, 0.025), tolerance);
  EXPECT_NEAR(strengths[0].weight_interval.upper, quantile(posterior, 0.975), tolerance);
  EXPECT_NEAR(strengths[0].probability_of_being_best, cdf(complement(posterior, 0.5)), tolerance);
}

TEST(PlackettLuce, IsTheMeanOverAllOrdersOfTies) {
  const auto strengths = plackett_luce(repeated({{1}, {0}}, 4) + repeated({{0, 1}}, 6), 2, 1);
  const boost::math::binomial broken(6, 0.5);
  double weight = 0;
  double best = 0;
  for (int wins = 0; wins <= 6; ++wins) {
    const boost::math::beta_distribution<> posterior(1 + wins, 11 - wins);
    weight += pdf(broken, wins) * mean(posterior);
    best += pdf(broken, wins) * cdf(complement(posterior, 0.5));
  }
  EXPECT_NEAR(strengths[0].weight, weight, tolerance);
  EXPECT_NEAR(strengths[0].probability_of_being_best, best, 2 * tolerance);
}

TEST(PlackettLuce, GivesAThirdToEachOfThreeIdenticalSolvers) {
  for (const auto& strength : plackett_luce(repeated({{0, 1, 2}}, 30), 3, 2)) {
    EXPECT_NEAR(strength.weight, 1.0 / 3, 0.02);
    EXPECT_NEAR(strength.probability_of_being_best, 1.0 / 3, 0.06);  // of 400 orders of the ties
  }
}

/// P(rankings) at the weights, which the ranking's own definition gives. No ties.
double likelihood(const std::vector<Ranking>& rankings, const std::array<double, 3>& weights) {
  double product = 1;
  for (const Ranking& ranking : rankings) {
    for (std::size_t i = 0; i < ranking.size(); ++i) {
      double standing = 0;
      for (std::size_t k = i; k < ranking.size(); ++k) standing += weights[ranking[k][0]];
      product *= weights[ranking[i][0]] / standing;
    }
  }
  return product;
}

TEST(PlackettLuce, IsTheIntegralOverAllWeightsOfThreeSolversSomeOfThemAbsent) {
  const std::vector<std::vector<Ranking>> cases = {
      repeated({{0}, {1}, {2}}, 3) + repeated({{2}, {0}, {1}}, 2) + repeated({{1}, {2}}, 2),
      repeated({{0}, {1}}, 5) + repeated({{1}, {2}}, 5) + repeated({{2}, {1}}, 2),  // never 0 and 2
      repeated({{2}}, 9) + repeated({{1}, {0}}, 1),                                 // 2 met nobody
  };
  for (const auto& rankings : cases) {
    std::array<double, 3> weight{};
    std::array<double, 3> best{};
    double all = 0;
    constexpr int steps = 150;
    for (int i = 0; i < steps; ++i) {
      for (int k = 0; i + k < steps - 1; ++k) {
        const double a = (i + 0.4) / steps;  // no two are ever equal
        const double b = (k + 0.5) / steps;
        const std::array<double, 3> weights = {a, b, 1 - a - b};
        const double density = likelihood(rankings, weights);
        all += density;
        for (std::size_t s = 0; s < 3; ++s) weight[s] += density * weights[s];
        best[static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) -
                                      weights.begin())] += density;
      }
    }
    const auto strengths = plackett_luce(rankings, 3, 3);
    for (std::size_t s = 0; s < 3; ++s) {
      EXPECT_NEAR(strengths[s].weight, weight[s] / all, tolerance);
      EXPECT_NEAR(strengths[s].probability_of_being_best, best[s] / all, 2 * tolerance);
    }
  }
}

TEST(PlackettLuce, GivesTheSameForTheSameSeed) {
  const std::vector<Ranking> rankings = repeated({{0, 1}, {2}}, 5);
  const auto a = plackett_luce(rankings, 3, 4);
  const auto b = plackett_luce(rankings, 3, 4);
  const auto c = plackett_luce(rankings, 3, 5);
  EXPECT_EQ(a[0].weight, b[0].weight);
  EXPECT_NE(a[0].weight, c[0].weight);
}

TEST(PlackettLuce, GivesTheSameBitsOnAnyNumberOfThreads) {
  const std::vector<Ranking> rankings = repeated({{0, 1}, {2}}, 5);
  const auto parallel = plackett_luce(rankings, 3, 4);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto serial = plackett_luce(rankings, 3, 4);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(parallel[k].weight, serial[k].weight);
    EXPECT_EQ(parallel[k].weight_interval.upper, serial[k].weight_interval.upper);
    EXPECT_EQ(parallel[k].probability_of_being_best, serial[k].probability_of_being_best);
  }
}

/// So many that there are a tenth of the sweeps, and several draws after each.
TEST(PlackettLuce, IsABetaDistributionOfTwoSolversAfterManyRankings) {
  const int times = 30000;
  const auto strengths =
      plackett_luce(repeated({{0}, {1}}, times + 150) + repeated({{1}, {0}}, times), 2, 6);
  const boost::math::beta_distribution<> posterior(times + 151, times + 1);
  const double deviation = std::sqrt(variance(posterior));
  EXPECT_NEAR(strengths[0].weight, mean(posterior), 0.15 * deviation);
  EXPECT_NEAR(strengths[0].weight_interval.lower, quantile(posterior, 0.025), 0.3 * deviation);
  EXPECT_NEAR(strengths[0].weight_interval.upper, quantile(posterior, 0.975), 0.3 * deviation);
  EXPECT_NEAR(strengths[0].probability_of_being_best, cdf(complement(posterior, 0.5)),
              2 * tolerance);
}

TEST(PlackettLuce, RefusesRankingsThatDoNotFit) {
  EXPECT_TRUE(plackett_luce({}, 0, 1).empty());
  EXPECT_THROW(plackett_luce({{{0}, {2}}}, 2, 1), std::invalid_argument);
  EXPECT_THROW(plackett_luce({{{0}, {1, 0}}}, 2, 1), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
