#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "problems/carrier_track/suite/robust.h"

namespace ricochet::carrier_track {
namespace {

std::vector<double> random_losses(std::size_t size, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<int> counts(0, 9);
  std::vector<double> losses;
  for (std::size_t k = 0; k < size; ++k) losses.push_back(counts(random));
  return losses;
}

/// The definition of Rockafellar and Uryasev; its minimum is at one of the losses.
double cvar_by_definition(const std::vector<double>& losses) {
  double least = std::numeric_limits<double>::infinity();
  for (const double t : losses) {
    double excess = 0;
    for (const double loss : losses) excess += std::max(0.0, loss - t);
    least = std::min(least, t + excess / (0.1 * static_cast<double>(losses.size())));
  }
  return least;
}

TEST(RiskMeasure, OfTwentyLossesByHand) {
  std::vector<double> losses(20, 1.0);
  losses[3] = 9;
  losses[17] = 5;
  EXPECT_DOUBLE_EQ(risk_of(RiskMeasure::mean, losses), (18 + 9 + 5) / 20.0);
  EXPECT_DOUBLE_EQ(risk_of(RiskMeasure::worst, losses), 9);
  EXPECT_DOUBLE_EQ(risk_of(RiskMeasure::cvar, losses), 7);  // of the worst two
}

/// A tenth of 32 is 3.2: three whole ones and a fifth of the fourth.
TEST(RiskMeasure, CountsTheLastOfTheTailInPart) {
  std::vector<double> losses(32, 0.0);
  losses[0] = 10, losses[9] = 6, losses[20] = 8, losses[31] = 4;
  EXPECT_DOUBLE_EQ(risk_of(RiskMeasure::cvar, losses), (10 + 8 + 6 + 0.2 * 4) / 3.2);
}

TEST(RiskMeasure, OfTheTailIsTheConditionalValueAtRisk) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const auto losses = random_losses(seed % 2 == 0 ? 32 : 25, seed);
    EXPECT_NEAR(risk_of(RiskMeasure::cvar, losses), cvar_by_definition(losses), 1e-12);
  }
}

TEST(RiskMeasure, OfTheTailLiesBetweenMeanAndWorst) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const auto losses = random_losses(32, seed);
    EXPECT_LE(risk_of(RiskMeasure::mean, losses), risk_of(RiskMeasure::cvar, losses));
    EXPECT_LE(risk_of(RiskMeasure::cvar, losses), risk_of(RiskMeasure::worst, losses));
  }
}

TEST(RiskMeasure, NeverFallsWhenALossRises) {
  for (const RiskMeasure risk : {RiskMeasure::mean, RiskMeasure::worst, RiskMeasure::cvar}) {
    for (unsigned seed = 0; seed < 20; ++seed) {
      auto losses = random_losses(32, seed);
      const double before = risk_of(risk, losses);
      losses[seed] += 1;
      EXPECT_GE(risk_of(risk, losses), before);
    }
  }
}

/// A limit that is met exactly must not be missed by rounding.
TEST(RiskMeasure, OfEqualWholeLossesIsExact) {
  for (const RiskMeasure risk : {RiskMeasure::mean, RiskMeasure::worst, RiskMeasure::cvar}) {
    for (const double loss : {7.0, 18.0, 1e6 + 1}) {
      EXPECT_EQ(risk_of(risk, std::vector<double>(32, loss)), loss);
    }
  }
}

TEST(RiskMeasure, WeightsSumToOne) {
  EXPECT_THAT(risk_weights(RiskMeasure::worst, 3), testing::ElementsAre(1, 0, 0));
  EXPECT_THAT(risk_weights(RiskMeasure::mean, 4), testing::Each(0.25));
  EXPECT_THAT(risk_weights(RiskMeasure::cvar, 5), testing::ElementsAre(1, 0, 0, 0, 0));
}

}  // namespace
}  // namespace ricochet::carrier_track
