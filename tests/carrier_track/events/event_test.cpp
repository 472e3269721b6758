#include "problems/carrier_track/motion/event.h"

#include "tests/support/numbers.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

using testing::_;
using testing::FieldsAre;

/// A flight seen in its direction, in long double and by the plain integrals of its forces.
struct TrueValues {
  const Flight<double>& flight;
  int direction;

  long double push(long double t) const {
    return direction * (flight.steady + sum([&](const auto& h, long double w) {
                          return h.cosine * std::cos(w * t) - h.sine * std::sin(w * t);
                        }));
  }
  long double speed(long double t) const {
    return direction *
           (flight.velocity + flight.steady * t + sum([&](const auto& h, long double w) {
              const long double half = std::sin(w * t / 2);
              return (h.cosine * std::sin(w * t) - h.sine * 2 * half * half) / w;
            }));
  }
  long double distance(long double t) const {
    return direction *
           (t * (flight.velocity + flight.steady * t / 2) + sum([&](const auto& h, long double w) {
              const long double half = std::sin(w * t / 2);
              return (h.cosine * 2 * half * half - h.sine * (w * t - std::sin(w * t))) / (w * w);
            }));
  }

 private:
  template <class Term>
  long double sum(const Term& term) const {
    long double sum = 0;
    for (int i = 0; i < flight.harmonics; ++i) {
      const auto& h = flight.harmonic[static_cast<std::size_t>(i)];
      sum += term(h, static_cast<long double>(h.frequency));
    }
    return sum;
  }
};

class EventTest : public testing::Test {
 protected:
  double within(double a, double b) { return std::uniform_real_distribution(a, b)(random_); }
  double log_within(double a, double b) { return a * std::pow(b / a, within(0, 1)); }

  Harmonic<double> random_harmonic() { return {within(-1, 1), within(-1, 1), log_within(0.3, 30)}; }

  Flight<double> random_flight() {
    return {within(-1, 1), 0.0, within(-1, 1), {{random_harmonic(), random_harmonic()}}, 2};
  }

  Event next(Flight<double> flight, int direction, double ahead, double horizon) {
    return next_event(flight, direction, ahead, horizon, evaluations_);
  }
  Event release(const Flight<double>& applied, double friction, bool may_rise, bool may_fall,
                double horizon) {
    return next_release(applied, friction, may_rise, may_fall, horizon, evaluations_);
  }

  std::mt19937_64 random_{1};
  std::int64_t evaluations_ = 0;
};

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
    const Event event = next(flight, direction, ahead, 5.0);
    expect_first_event(flight, direction, ahead, 5.0, event);
    walls += event.kind == EventKind::wall;
    turns += event.kind == EventKind::turn;
    if (HasFatalFailure()) FAIL() << "trial " << trial;
  }
  EXPECT_GT(walls, 500);
  EXPECT_GT(turns, 500);
  EXPECT_LT(evaluations_, 2000 * 20);
}

TEST_F(EventTest, TellsAWallJustWithinReachFromOneJustBeyond) {
  // The turning point of a flight without walls is how far it reaches.
  for (int trial = 0; trial < 2000; ++trial) {
    Flight<double> flight = random_flight();
    const int direction = trial % 2 == 0 ? 1 : -1;
    flight.velocity = direction * log_within(1e-3, 3);
    const Event turn = next(flight, direction, infinity, 50.0);
    if (turn.kind != EventKind::turn) continue;
    const auto reach = static_cast<double>(TrueValues{flight, direction}.distance(turn.time));
    // A flight of length T knows its place to about 1e-16 (1 + T^2).
    const double least = 1e-14 * (1 + turn.time * turn.time);
    for (const double clearance : {least, 1e3 * least, 1e6 * least}) {
      const Event hit = next(flight, direction, reach - clearance, 50.0);
      EXPECT_EQ(hit.kind, EventKind::wall) << trial << ", within reach by " << clearance;
      EXPECT_LE(hit.time, turn.time);
      const Event miss = next(flight, direction, reach + clearance, 50.0);
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
        const Event event = next(flight, 1, infinity, 2.0);
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

TEST_F(EventTest, IsImmediateAtAWallAndNeverBeyondTheHorizon) {
  Flight<double> flight{0.0, 1.0, 0.0, {}, 0};
  EXPECT_THAT(next(flight, 1, 0.0, 1.0), FieldsAre(EventKind::wall, 0.0, 1));
  EXPECT_THAT(next(flight, 1, 2.0, 1.0), FieldsAre(EventKind::horizon, 1.0, 1));
}

TEST_F(EventTest, LetsABodyAtRestSetOutUnderAForceThatOnlyGrows) {
  // At the moment of departure the acceleration is zero but for rounding, and only the jerk leads.
  for (const double rounding : {-1e-16, 0.0, 1e-16}) {
    Flight<double> flight{0.0, 0.0, rounding, {}, 1};
    flight.harmonic[0] = {0.0, -1.0, 5.0};  // x'' = sin(5 t)
    const Event event = next(flight, 1, 1e-3, 1.0);
    EXPECT_EQ(event.kind, EventKind::wall);
    EXPECT_NEAR(static_cast<double>(TrueValues{flight, 1}.distance(event.time)), 1e-3, 1e-16);
  }
}

using DepartureTest = EventTest;

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
    const Event event = release(applied, friction, may_rise, may_fall, 5.0);
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
    const Event leaves = release(applied, 2 - clearance, true, true, 2.0);
    EXPECT_EQ(leaves.kind, EventKind::release) << clearance;
    EXPECT_NEAR(leaves.time, peak - std::acos(1 - clearance) / 3,
                1e-15 / std::sqrt(clearance) + 1e-15);
    EXPECT_EQ(release(applied, 2 + clearance, true, true, 2.0).kind, EventKind::horizon);
    EXPECT_EQ(release(applied, 2 - clearance, false, true, 2.0).kind, EventKind::horizon)
        << "a wall holds it";
  }
}

TEST_F(DepartureTest, AConstantForceWithinTheBandHoldsForever) {
  const Flight<double> applied{0.0, 0.0, 0.5, {}, 0};
  EXPECT_THAT(release(applied, 0.5, true, true, 7.0), FieldsAre(EventKind::horizon, 7.0, _));
}

TEST(ZenoTail, IsTheSumOfItsHops) {
  for (const double e : {0.0, 0.1, 0.5, 0.99}) {
    for (const double friction : {0.0, 0.7, 1.9}) {
      const double press = 2.0;
      double sum = 0;
      for (double speed = 3e-9; speed > 1e-30;) {
        const double up = speed / (press + friction);
        const double height = speed * up / 2;
        const double down = std::sqrt(2 * height / (press - friction));
        sum += up + down;
        speed = e * (press - friction) * down;
      }
      EXPECT_NEAR(zeno_tail(3e-9, e, press, friction), sum, 1e-12 * sum);
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
