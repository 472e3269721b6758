#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "problems/carrier_track/motion/event.h"
#include "tests/carrier_track/flight/random_flights.h"
#include "tests/support/numbers.h"

namespace ricochet::carrier_track {
namespace {

using DepartureTest = RandomFlightTest;

TEST_F(DepartureTest, IsTheFirstThatDenseSamplingFinds) {
  int departures = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Flight<double> applied = random_flight();
    const bool may_rise = trial % 3 != 0;
    const bool may_fall = trial % 3 != 1;
    const double push = static_cast<double>(TrueValues{applied, 1}.push(0));
    // At rest to begin with: friction holds, or a wall takes the way.
    double friction = within(0, 2);
    if ((push > 0 && may_rise) || (push < 0 && may_fall)) friction += std::abs(push);
    const Event event = next_release(applied, friction, may_rise, may_fall, 5.0, evaluations_);
    const double noise = 1e-14 * (5 + friction);
    if (event.kind == EventKind::release) {
      ++departures;
      const TrueValues true_values{applied, event.direction};
      EXPECT_TRUE(event.direction > 0 ? may_rise : may_fall);
      EXPECT_NEAR(static_cast<double>(true_values.push(event.time)), friction, noise);
      EXPECT_GT(true_values.push(event.time + 1e-6), friction) << trial;
    } else {
      EXPECT_EQ(event.kind, EventKind::horizon);
      EXPECT_EQ(event.time, 5.0);
    }
    for (int i = 1; i < 1000; ++i) {
      const long double t = static_cast<long double>(event.time) * i / 1000;
      const long double a = TrueValues{applied, 1}.push(t);
      ASSERT_LE(a, may_rise ? friction + noise : infinity) << trial;
      ASSERT_GE(a, may_fall ? -friction - noise : -infinity) << trial;
    }
  }
  EXPECT_GT(departures, 500);
}

TEST_F(DepartureTest, NeedsTheForceToLeaveTheBand) {
  // The peak of 1 + sin(3 t) is 2, reached at t = pi / 6.
  Flight<double> applied{0.0, 0.0, 1.0, {}, 1};
  applied.harmonic[0] = {0.0, -1.0, 3.0};
  const double peak = std::numbers::pi / 6;
  for (const double clearance : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const Event leaves = next_release(applied, 2 - clearance, true, true, 2.0, evaluations_);
    EXPECT_EQ(leaves.kind, EventKind::release) << clearance;
    EXPECT_NEAR(leaves.time, peak - std::acos(1 - clearance) / 3,
                1e-15 / std::sqrt(clearance) + 1e-15);
    EXPECT_EQ(next_release(applied, 2 + clearance, true, true, 2.0, evaluations_).kind,
              EventKind::horizon);
    EXPECT_EQ(next_release(applied, 2 - clearance, false, true, 2.0, evaluations_).kind,
              EventKind::horizon)
        << "a wall holds it";
  }
}

TEST_F(DepartureTest, AConstantForceWithinTheBandHoldsForever) {
  const Flight<double> applied{0.0, 0.0, 0.5, {}, 0};
  const Event event = next_release(applied, 0.5, true, true, 7.0, evaluations_);
  EXPECT_EQ(event.kind, EventKind::horizon);
  EXPECT_EQ(event.time, 7.0);
}

}  // namespace
}  // namespace ricochet::carrier_track
