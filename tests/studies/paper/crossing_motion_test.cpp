#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "src/studies/paper/theory.h"

namespace ricochet::carrier_track {
namespace {

constexpr double radius = 0.065;
constexpr double omega = 7.0;

/// The normal and tangential parts of equation (4) [m/s^2] on the crossing.
struct CrossingParts {
  double normal;      ///< r w^2 / cos(angle)
  double tangential;  ///< dV/dt = 2 r w^2 sin(angle) / cos^3(angle)
};

CrossingParts parts_at(double angle) {
  const double c = std::cos(angle);
  const double push = radius * omega * omega;
  return {push / c, 2 * push * std::sin(angle) / (c * c * c)};
}

TEST(Transition, MovesEvenlyOnTheArc) {
  const TheoreticalMotion m = on_arc(radius, omega);
  EXPECT_DOUBLE_EQ(m.speed, 0.455);
  EXPECT_DOUBLE_EQ(m.acceleration, 3.185);
}

TEST(Transition, MeetsTheArcWhereTheCrossingIsTangentToIt) {
  EXPECT_DOUBLE_EQ(on_crossing(radius, omega, 0.0).speed, on_arc(radius, omega).speed);
  EXPECT_DOUBLE_EQ(on_crossing(radius, omega, 0.0).acceleration,
                   on_arc(radius, omega).acceleration);
}

TEST(Transition, HasTheTangentialPartOfItsOwnSpeed) {
  // a_tau = dV/dt with angle = omega t, by a central difference of equation (3).
  for (double angle = -1.2; angle <= 1.2; angle += 0.1) {
    const double h = 1e-6;
    const double slope = (on_crossing(radius, omega, angle + h).speed -
                          on_crossing(radius, omega, angle - h).speed) /
                         (2 * h) * omega;
    EXPECT_NEAR(parts_at(angle).tangential, slope, 1e-7 * (1 + std::abs(slope)));
  }
}

TEST(Transition, GivesEquation5FromEquation4WithTheAngleReadAsNinetyDegreesMore) {
  for (double angle = -1.4; angle <= 1.4; angle += 0.05) {
    const CrossingParts p = parts_at(angle);
    const auto composed = [&](double cosine) {
      return std::sqrt(p.normal * p.normal + p.tangential * p.tangential +
                       2 * p.normal * p.tangential * cosine);
    };
    const double a = on_crossing(radius, omega, angle).acceleration;
    EXPECT_NEAR(composed(-std::sin(angle)), a, 1e-12 * a);
    if (std::abs(angle) > 0.1) {
      EXPECT_GT(std::abs(composed(std::cos(angle)) - a), 1e-3 * a) << "the extraction's cosine";
    }
  }
}

TEST(Transition, MakesACrossingOfEveryHalfTurn) {
  const double angle = 0.5;
  const auto knots = crossing_profile(omega, angle, 1.7);
  ASSERT_EQ(knots.size(), 20U);  // four half turns, five knots each
  for (std::size_t k = 0; k < knots.size(); ++k) {
    EXPECT_GT(knots[k].time, k > 0 ? knots[k - 1].time : 0.0);
    // Each knot lies on equation (3), over the plate's angle from the nearer tangent.
    const double plate = omega * knots[k].time;
    const double half_turn = std::numbers::pi;
    const double from_middle = std::remainder(plate - half_turn / 2, half_turn);
    const double driven = angle - std::abs(from_middle);
    EXPECT_NEAR(knots[k].omega, on_crossing(1.0, omega, driven).speed, 1e-9);
  }
  EXPECT_NEAR(knots.front().omega, omega, 1e-12);
}

}  // namespace
}  // namespace ricochet::carrier_track
