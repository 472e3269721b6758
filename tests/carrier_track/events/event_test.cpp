#include "problems/carrier_track/motion/event.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/carrier_track/flight/random_flights.h"
#include "tests/support/numbers.h"

namespace ricochet::carrier_track {
namespace {

using EventTest = RandomFlightTest;

/// The event, without the way to it.
Event next_event_of(Flight<double> flight, int direction, double ahead, double horizon,
                    std::int64_t& evaluations) {
  return next_event(flight, direction, ahead, horizon, evaluations);
}

/// Holds for an event of `flight` that is real, and before which nothing happens.
void expect_first_event(const Flight<double>& flight, int direction, double ahead, double horizon,
                        const Event& event) {
  const TrueValues true_values{flight, direction};
  ASSERT_GE(event.time, 0.0);
  ASSERT_LE(event.time, horizon);
  EXPECT_EQ(event.direction, direction);
  // What double precision can resolve of a distance and a speed at the time of the event.
  const auto travelled = static_cast<double>(true_values.distance(event.time));
  const double speed_noise = 1e-14 * (1 + std::abs(flight.velocity) + 4 * event.time);
  switch (event.kind) {
    case EventKind::wall:
      EXPECT_NEAR(travelled, ahead, 1e-15 * (1 + 4 * event.time * event.time));
      EXPECT_GE(true_values.speed(event.time), -speed_noise);
      break;
    case EventKind::turn:
      EXPECT_NEAR(static_cast<double>(true_values.speed(event.time)), 0.0, speed_noise);
      EXPECT_LE(true_values.push(event.time), 1e-9);
      break;
    default:
      EXPECT_EQ(event.kind, EventKind::horizon);
      EXPECT_EQ(event.time, horizon);
  }
  constexpr int samples = 1000;
  for (int i = 1; i < samples; ++i) {
    const long double t = static_cast<long double>(event.time) * i / samples;
    ASSERT_LE(true_values.distance(t), ahead + 1e-14) << "a wall is skipped";
    ASSERT_GE(true_values.speed(t), -speed_noise) << "a turn is skipped";
  }
}

TEST_F(EventTest, IsTheFirstThatDenseSamplingFinds) {
  int walls = 0;
  int turns = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    Flight<double> flight = random_flight();
    const int direction = trial % 2 == 0 ? 1 : -1;
    flight.velocity = direction * log_within(1e-6, 3);
    const double ahead = log_within(1e-9, 3);
    const Event event = next_event_of(flight, direction, ahead, 5.0, evaluations_);
    expect_first_event(flight, direction, ahead, 5.0, event);
    walls += event.kind == EventKind::wall;
    turns += event.kind == EventKind::turn;
    if (HasFatalFailure()) FAIL() << "trial " << trial;
  }
  EXPECT_GT(walls, 500);
  EXPECT_GT(turns, 500);
  RecordProperty("evaluations_per_event", std::to_string(static_cast<double>(evaluations_) / 2000));
  EXPECT_LT(evaluations_, 2000 * 20);
}

TEST_F(EventTest, TellsAWallJustWithinReachFromOneJustBeyond) {
  // The turning point of a flight without walls is how far it reaches.
  for (int trial = 0; trial < 2000; ++trial) {
    Flight<double> flight = random_flight();
    const int direction = trial % 2 == 0 ? 1 : -1;
    flight.velocity = direction * log_within(1e-3, 3);
    const Event turn = next_event_of(flight, direction, infinity, 50.0, evaluations_);
    if (turn.kind != EventKind::turn) continue;
    const auto reach = static_cast<double>(TrueValues{flight, direction}.distance(turn.time));
    // A flight of length T knows its place to about 1e-16 (1 + T^2).
    const double least = 1e-14 * (1 + turn.time * turn.time);
    for (const double clearance : {least, 1e3 * least, 1e6 * least}) {
      const Event hit = next_event_of(flight, direction, reach - clearance, 50.0, evaluations_);
      EXPECT_EQ(hit.kind, EventKind::wall) << trial << ", within reach by " << clearance;
      EXPECT_LE(hit.time, turn.time);
      const Event miss = next_event_of(flight, direction, reach + clearance, 50.0, evaluations_);
      EXPECT_EQ(miss.kind, EventKind::turn) << trial << ", out of reach by " << clearance;
      EXPECT_NEAR(miss.time, turn.time, 1e-13 * turn.time);
    }
  }
}

TEST_F(EventTest, TellsASlowPassageFromATurn) {
  // x'' = a sin(t - 1) (a > 0) is slowest at t = 1, with the speed the start has left over.
  for (const double amplitude : {0.01, 1.0, 100.0}) {
    for (const double left : {1e-3, 1e-6, 1e-9, 1e-12}) {
      for (const int sign : {1, -1}) {
        Flight<double> flight{0.0, 0.0, 0.0, {}, 1};
        flight.harmonic[0] = {-amplitude * std::sin(1.0), -amplitude * std::cos(1.0), 1.0};
        const double loss = amplitude * 2 * std::sin(0.5) * std::sin(0.5);
        flight.velocity = loss + sign * left * amplitude;
        const Event event = next_event_of(flight, 1, infinity, 2.0, evaluations_);
        EXPECT_EQ(event.kind, sign > 0 ? EventKind::horizon : EventKind::turn)
            << amplitude << " " << left;
        // v = left + a (1 - cos(t - 1)) has its first zero where cos = 1 - left.
        if (sign < 0) {
          EXPECT_NEAR(event.time, 1 - std::acos(1 - left), 1e-15 / std::sqrt(left) + 1e-14);
        }
      }
    }
  }
}

TEST_F(EventTest, FindsTheShortestOfContacts) {
  // Thrown at 1 m/s, back after 2 v / g; a wall a billionth below the apex is touched for 90 us.
  Flight<double> flight{0.0, 1.0, -1.0, {}, 0};
  const Event event = next_event_of(flight, 1, 0.5 - 1e-9, 10.0, evaluations_);
  EXPECT_EQ(event.kind, EventKind::wall);
  EXPECT_NEAR(event.time, 1 - std::sqrt(2e-9), 1e-11);
  EXPECT_EQ(next_event_of(flight, 1, 0.5 + 1e-9, 10.0, evaluations_).kind, EventKind::turn);
}

TEST_F(EventTest, IsImmediateAtAWallAndNeverBeyondTheHorizon) {
  Flight<double> flight{0.0, 1.0, 0.0, {}, 0};
  EXPECT_EQ(next_event_of(flight, 1, 0.0, 1.0, evaluations_).kind, EventKind::wall);
  EXPECT_EQ(next_event_of(flight, 1, 0.0, 1.0, evaluations_).time, 0.0);
  const Event event = next_event_of(flight, 1, 2.0, 1.0, evaluations_);
  EXPECT_EQ(event.kind, EventKind::horizon);
  EXPECT_EQ(event.time, 1.0);
}

TEST_F(EventTest, LetsABodyAtRestSetOutUnderAForceThatOnlyGrows) {
  // At the moment of departure the acceleration is zero but for rounding, and only the jerk leads.
  for (const double rounding : {-1e-16, 0.0, 1e-16}) {
    Flight<double> flight{0.0, 0.0, rounding, {}, 1};
    flight.harmonic[0] = {0.0, -1.0, 5.0};  // x'' = sin(5 t)
    const Event event = next_event_of(flight, 1, 1e-3, 1.0, evaluations_);
    EXPECT_EQ(event.kind, EventKind::wall);
    EXPECT_NEAR(static_cast<double>(TrueValues{flight, 1}.distance(event.time)), 1e-3, 1e-16);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
