#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "problems/carrier_track/identification/knock_loss.h"
#include "problems/carrier_track/identification/knock_unknowns.h"

namespace ricochet::carrier_track {
namespace {

const KnockUnknowns unknowns{.restitution = 0.5,
                             .friction = 0.2,
                             .clearance = 1e-3,
                             .phase = 0,
                             .speed_factor = 1,
                             .jitter = 1e-3,
                             .recorded_share = 0.8,
                             .spurious_rate = 0.5,
                             .detection_limit = 5e-3,
                             .gain = 1,
                             .scatter = 0.1};

const KnockRecord silent{{}, {{0, 5}}, 0, 10, {}};

/// One strong impact, 1 s after the start; one exactly at the detection limit, half a second later.
std::vector<PredictedImpact> two_impacts() {
  return {{1.0, std::log(0.1)}, {1.5, std::log(5e-3)}};
}

TEST(KnockDensity, IsAGaussianAroundEachImpactAboveASpuriousRate) {
  const KnockDensity density(silent, two_impacts(), point_of(unknowns), 0);
  const double peak = 0.8 / (1e-3 * std::sqrt(2 * std::numbers::pi));
  EXPECT_NEAR(density.log_at({1.0}, nullptr), std::log(0.5 + peak), 1e-12);
  EXPECT_NEAR(density.log_at({1.002}, nullptr), std::log(0.5 + peak * std::exp(-2)), 1e-9);
  EXPECT_NEAR(density.log_at({1.5}, nullptr), std::log(0.5 + peak / 2), 1e-12);
  EXPECT_NEAR(density.log_at({3.0}, nullptr), std::log(0.5), 1e-12);
}

TEST(KnockDensity, ExpectsAsManyKnocksAsItIntegratesTo) {
  const KnockDensity density(silent, two_impacts(), point_of(unknowns), 0);
  EXPECT_NEAR(density.expected(nullptr), 5 + 0.8 + 0.4, 1e-12);
  double integral = 0;
  const double step = 1e-4;
  for (double t = step / 2; t < 10; t += step) {
    integral += step * std::exp(density.log_at({t}, nullptr));
  }
  EXPECT_NEAR(integral, density.expected(nullptr), 1e-6);
}

/// After a knock the sensor is deaf: the impact that it is of has been heard, and another, even one
/// that follows within a jitter or two, is not expected. Of two that may be it, one is.
TEST(KnockDensity, ExpectsNoOtherImpactInTheDeadTimeAfterAKnock) {
  KnockRecord record = silent;
  record.knocks = {{1.0}};
  record.dead_time = 0.02;
  const double spurious = 0.5 * (10 - record.dead_time);
  for (const double later : {0.003, 0.006, 0.015}) {
    const std::vector<PredictedImpact> impacts = {{1.0, std::log(0.1)}, {1 + later, std::log(0.1)}};
    const KnockDensity density(record, impacts, point_of(unknowns), 0);
    EXPECT_NEAR(density.expected(nullptr), spurious + 0.8, 0.02) << later;
  }
  const std::vector<PredictedImpact> alike = {{1.0, std::log(0.1)}, {1.0, std::log(0.1)}};
  const KnockDensity either(record, alike, point_of(unknowns), 0);
  // Half of the second is before the knock, where the sensor would have heard it.
  EXPECT_NEAR(either.expected(nullptr), spurious + 0.8 * 1.5, 0.02);
}

TEST(KnockDensity, IsWiderByABlurOfThePlatesAngle) {
  const KnockDensity density(silent, two_impacts(), point_of(unknowns), 0.05);
  const double width = std::hypot(1e-3, 0.01);
  EXPECT_NEAR(density.log_at({1.01}, nullptr),
              std::log(0.5 + 0.8 / (width * std::sqrt(2 * std::numbers::pi)) *
                                 std::exp(-std::pow(0.01 / width, 2) / 2)),
              1e-9);
}

TEST(KnockDensity, OfStrengthsIsPerLogarithmOfStrength) {
  KnockRecord record = silent;
  record.knocks = {{0.5, 0.01}, {2, 0.1}};  // the range of strengths: a factor of ten
  const KnockDensity density(record, two_impacts(), point_of(unknowns), 0);
  const double peak =
      0.8 / (1e-3 * std::sqrt(2 * std::numbers::pi)) / (0.1 * std::sqrt(2 * std::numbers::pi));
  const double spurious = 0.5 / std::log(10.0);
  EXPECT_NEAR(density.log_at({1.0, 0.1}, nullptr), std::log(spurious + peak), 1e-12);
  EXPECT_NEAR(density.log_at({1.0, 0.1 * std::exp(0.2)}, nullptr),
              std::log(spurious + peak * std::exp(-2)), 1e-9);
}

/// With one impact the information is known: its time counts as one Gaussian measurement in the
/// share of records in which it appears; that share has the variance of a yes or no.
TEST(KnockDensity, HasTheInformationOfIndependentImpacts) {
  KnockUnknowns at = unknowns;
  at.spurious_rate = 1e-6;
  std::vector<PredictedImpact> impact = {{1.0, std::log(0.1)}};
  impact[0].time_slopes[2] = 3;
  const auto both = KnockDensity(silent, impact, point_of(at), 0).information();
  EXPECT_NEAR(both.information(2, 2), 0.8 * 9 / 1e-6, 0.01 * 0.8 * 9 / 1e-6);
  EXPECT_NEAR(both.score(2, 2), both.information(2, 2), 1e-6 * both.information(2, 2));
  EXPECT_NEAR(both.information(5, 5), 0.8 * 2, 0.02);  // of the logarithm of the jitter
  EXPECT_NEAR(both.information(6, 6), 0.8 * 0.2 * 0.2, 1e-3);
  EXPECT_NEAR(both.score(6, 6), 0.8 * 0.2 * 0.2 * 0.2, 1e-3);
}

}  // namespace
}  // namespace ricochet::carrier_track
