#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/check/push.h"

namespace ricochet::carrier_track {
namespace {

/// Simpson's rule, in steps much finer than the force changes.
struct Integrated {
  long double speed = 0, distance = 0;
};

Integrated integrated(const PushTerm& term, long double from, long double elapsed) {
  constexpr int steps = 4000;
  const auto acceleration = [&](long double u) {
    const auto& [a, p] = term;
    return (a[0] + u * (a[1] + u * a[2])) * std::cos(p[0] + u * (p[1] + u * p[2]));
  };
  Integrated sum;
  const long double h = elapsed / steps;
  for (int k = 0; k <= steps; ++k) {
    const long double weight = (k == 0 || k == steps ? 1 : k % 2 == 1 ? 4 : 2) * h / 3;
    const long double value = acceleration(from + h * k);
    sum.speed += weight * value;
    sum.distance += weight * value * (elapsed - h * k);
  }
  return sum;
}

TEST(TermPush, MovesABodyAsItsIntegralSays) {
  for (const PushTerm& term :
       {PushTerm{{1, 2, -3}, {0.3L, 5, 2}}, PushTerm{{0.5L, 0, 0}, {0, 0, 0}},
        PushTerm{{2, 0, 1}, {-1, 0, 40}}, PushTerm{{1, 1, 1}, {0, 0, 0}}}) {
    const TermPush push({{0, {term}}}, 2);
    for (const long double start : {0.0L, 0.7L}) {
      const long double elapsed = std::min(push.known_until(start) - start, 0.5L);
      const Pushed moved = TermPushFrom(push, start).after(elapsed);
      const Integrated expected = integrated(term, start, elapsed);
      EXPECT_NEAR(static_cast<double>(moved.speed - expected.speed), 0, 1e-15);
      EXPECT_NEAR(static_cast<double>(moved.distance - expected.distance), 0, 1e-15);
    }
  }
}

TEST(TermPush, HasTheDerivativesOfItsAcceleration) {
  const TermPush push({{0, {{{1, 2, -3}, {0.3L, 5, 2}}}}}, 2);
  const TermPushFrom from(push, 0.4L);
  const long double t = 0.05L, h = 1e-5L;
  const Pushed before = from.after(t - h), now = from.after(t), after = from.after(t + h);
  EXPECT_NEAR(static_cast<double>((after.acceleration - before.acceleration) / (2 * h) / now.jerk),
              1, 1e-8);
  EXPECT_NEAR(static_cast<double>((after.jerk - before.jerk) / (2 * h) / now.snap), 1, 1e-8);
  EXPECT_LE(std::abs(now.jerk), push.bound(1, 2));
  EXPECT_LE(std::abs(now.snap), push.bound(2, 2));
}

TEST(TermPush, EndsAtTheNextPiece) {
  const TermPush push({{0, {}}, {0.5L, {{{1, 0, 0}, {0, 100, 0}}}}}, 2);
  EXPECT_EQ(push.known_until(0.1L), 0.5L);
  EXPECT_EQ(push.smooth_until(0.1L), 0.5L);
  EXPECT_NEAR(static_cast<double>(push.known_until(0.5L)), 0.505, 1e-12);
  EXPECT_EQ(TermPushFrom(push, 0.1L).after(0.2L).acceleration, 0);
  EXPECT_EQ(TermPushFrom(push, 0.5L).after(0).acceleration, 1);
}

}  // namespace
}  // namespace ricochet::carrier_track
