#include "problems/carrier_track/motion/event.h"

#include "tests/carrier_track/models/watch.h"
#include "tests/support/numbers.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

using testing::_;

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

Harmonic<double> random_harmonic(RandomScenes& draws) {
  return {draws.within(-1, 1), draws.within(-1, 1), draws.log_within(0.3, 30)};
}

Flight<double> random_flight(RandomScenes& draws) {
  return {draws.within(-1, 1),
          0.0,
          draws.within(-1, 1),
          {{random_harmonic(draws), random_harmonic(draws)}},
          2};
}

Event first_event(Flight<double> flight, int direction, double ahead, double horizon) {
  std::int64_t evaluations = 0;
  const Event event = next_event(flight, direction, ahead, horizon, evaluations);
  EXPECT_LT(evaluations, 200);
  return event;
}

Event first_release(const Flight<double>& applied, double friction, bool may_rise, bool may_fall,
                    double horizon) {
  std::int64_t evaluations = 0;
  return next_release(applied, friction, may_rise, may_fall, horizon, evaluations);
}

/// Expects an event of `flight` that is real, and before which nothing happens.
void expect_first_event(const Flight<double>& flight, int direction, double ahead, double horizon,
                        const Event& event) {
  const TrueValues true_values{flight, direction};
  ASSERT_GE(event.time, 0.0);
  ASSERT_LE(event.time, horizon);
  EXPECT_EQ(event.direction, direction);
  // What double precision can resolve of a distance and a speed at the time of the event.
  const auto travelled = static_cast<double>(true_values.distance(event.time));
  const auto speed = static_cast<double>(true_values.speed(event.time));
  const double speed_noise = 1e-14 * (1 + std::abs(flight.velocity) + 4 * event.time);
  if (event.kind == EventKind::wall) {
    EXPECT_NEAR(travelled, ahead, 1e-15 * (1 + 4 * event.time * event.time));
    EXPECT_GE(speed, -speed_noise);
  } else if (event.kind == EventKind::turn) {
    EXPECT_NEAR(speed, 0.0, speed_noise);
    EXPECT_LE(true_values.push(event.time), 1e-9);
  } else {
    EXPECT_EQ(event.kind, EventKind::horizon);
    EXPECT_EQ(event.time, horizon);
  }
  for (int i = 1; i < 1000; ++i) {
    const long double t = static_cast<long double>(event.time) * i / 1000;
    ASSERT_LE(true_values.distance(t), ahead + 1e-14) << "a wall is skipped";
    ASSERT_GE(true_values.speed(t), -speed_noise) << "a turn is skipped";
  }
}

TEST(EventTest, IsTheFirstThatDenseSamplingFinds) {
  std::map<EventKind, int> found;
  std::int64_t evaluations = 0;
  for_random(1, 2000, [&](RandomScenes& draws) {
    Flight<double> flight = random_flight(draws);
    const int direction = draws.chance(0.5) ? 1 : -1;
    flight.velocity = direction * draws.log_within(1e-6, 3);
    const double ahead = draws.log_within(1e-9, 3);
    Flight<double> flown = flight;
    const Event event = next_event(flown, direction, ahead, 5.0, evaluations);
    expect_first_event(flight, direction, ahead, 5.0, event);
    ++found[event.kind];
  });
  EXPECT_GT(found[EventKind::wall], 500);
  EXPECT_GT(found[EventKind::turn], 500);
  EXPECT_LT(evaluations, 2000 * 20);
}

TEST(EventTest, TellsAWallJustWithinReachFromOneJustBeyond) {
  // The turning point of a flight without walls is how far it reaches.
  int turns = 0;
  for_random(2, 2000, [&](RandomScenes& draws) {
    Flight<double> flight = random_flight(draws);
    const int direction = draws.chance(0.5) ? 1 : -1;
    flight.velocity = direction * draws.log_within(1e-3, 3);
    const Event turn = first_event(flight, direction, infinity, 50.0);
    if (turn.kind != EventKind::turn) return;
    ++turns;
    const auto reach = static_cast<double>(TrueValues{flight, direction}.distance(turn.time));
    // A flight of length T knows its place to about 1e-16 (1 + T^2).
    const double least = 1e-14 * (1 + turn.time * turn.time);
    for (const double clearance : {least, 1e3 * least, 1e6 * least}) {
      const Event hit = first_event(flight, direction, reach - clearance, 50.0);
      EXPECT_EQ(hit.kind, EventKind::wall) << "within reach by " << clearance;
      EXPECT_LE(hit.time, turn.time);
      const Event miss = first_event(flight, direction, reach + clearance, 50.0);
      EXPECT_EQ(miss.kind, EventKind::turn) << "out of reach by " << clearance;
      EXPECT_NEAR(miss.time, turn.time, 1e-13 * turn.time);
    }
  });
  EXPECT_GT(turns, 500);
}

TEST(EventTest, TellsASlowPassageFromATurn) {
  // x'' = a sin(t - 1) (a > 0) is slowest at t = 1, with the speed the start has left over.
  for (const double amplitude : {0.01, 1.0, 100.0}) {
    const Harmonic<double> wave{-amplitude * std::sin(1.0), -amplitude * std::cos(1.0), 1.0};
    const double loss = amplitude * 2 * std::sin(0.5) * std::sin(0.5);
    for (const double left : {1e-3, 1e-6, 1e-9, 1e-12}) {
      SCOPED_TRACE(testing::Message() << amplitude << " " << left);
      const auto with_speed = [&](double speed) {
        return first_event({0.0, speed, 0.0, {{wave, {}}}, 1}, 1, infinity, 2.0);
      };
      EXPECT_EQ(with_speed(loss + left * amplitude).kind, EventKind::horizon);
      const Event turn = with_speed(loss - left * amplitude);
      EXPECT_EQ(turn.kind, EventKind::turn);
      // v = left + a (1 - cos(t - 1)) has its first zero where cos = 1 - left.
      EXPECT_NEAR(turn.time, 1 - std::acos(1 - left), 1e-15 / std::sqrt(left) + 1e-14);
    }
  }
}

TEST(EventTest, IsImmediateAtAWallAndNeverBeyondTheHorizon) {
  const Flight<double> flight{0.0, 1.0, 0.0, {}, 0};
  EXPECT_THAT(first_event(flight, 1, 0.0, 1.0), FieldsAre(EventKind::wall, 0.0, 1));
  EXPECT_THAT(first_event(flight, 1, 2.0, 1.0), FieldsAre(EventKind::horizon, 1.0, 1));
}

TEST(EventTest, LetsABodyAtRestSetOutUnderAForceThatOnlyGrows) {
  // At the moment of departure the acceleration is zero but for rounding, and only the jerk leads.
  for (const double rounding : {-1e-16, 0.0, 1e-16}) {
    const Flight<double> flight{0.0, 0.0, rounding, {{{0.0, -1.0, 5.0}, {}}}, 1};  // sin(5 t)
    const Event event = first_event(flight, 1, 1e-3, 1.0);
    EXPECT_EQ(event.kind, EventKind::wall);
    EXPECT_NEAR(static_cast<double>(TrueValues{flight, 1}.distance(event.time)), 1e-3, 1e-16);
  }
}

TEST(DepartureTest, IsTheFirstThatDenseSamplingFinds) {
  int departures = 0;
  for_random(3, 2000, [&](RandomScenes& draws) {
    const Flight<double> applied = random_flight(draws);
    const TrueValues up{applied, 1};
    const int ways = draws.below(3);
    const bool may_rise = ways != 0;
    const bool may_fall = ways != 1;
    const double push = static_cast<double>(up.push(0));
    // At rest to begin with: friction holds, or a wall takes the way.
    double friction = draws.within(0, 2);
    if ((push > 0 && may_rise) || (push < 0 && may_fall)) friction += std::abs(push);
    const Event event = first_release(applied, friction, may_rise, may_fall, 5.0);
    const double noise = 1e-14 * (5 + friction);
    if (event.kind == EventKind::release) {
      ++departures;
      EXPECT_TRUE(event.direction > 0 ? may_rise : may_fall);
      EXPECT_NEAR(static_cast<double>(event.direction * up.push(event.time)), friction, noise);
      EXPECT_GT(event.direction * up.push(event.time + 1e-6), friction);
    } else {
      EXPECT_THAT(event, FieldsAre(EventKind::horizon, 5.0, _));
    }
    for (int i = 1; i < 1000; ++i) {
      const long double a = up.push(static_cast<long double>(event.time) * i / 1000);
      ASSERT_LE(a, may_rise ? friction + noise : infinity);
      ASSERT_GE(a, may_fall ? -friction - noise : -infinity);
    }
  });
  EXPECT_GT(departures, 500);
}

TEST(DepartureTest, NeedsTheForceToLeaveTheBand) {
  // The peak of 1 + sin(3 t) is 2, reached at t = pi / 6.
  const Flight<double> applied{0.0, 0.0, 1.0, {{{0.0, -1.0, 3.0}, {}}}, 1};
  for (const double clearance : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const Event leaves = first_release(applied, 2 - clearance, true, true, 2.0);
    EXPECT_EQ(leaves.kind, EventKind::release) << clearance;
    EXPECT_NEAR(leaves.time, std::numbers::pi / 6 - std::acos(1 - clearance) / 3,
                1e-15 / std::sqrt(clearance) + 1e-15);
    EXPECT_EQ(first_release(applied, 2 + clearance, true, true, 2.0).kind, EventKind::horizon);
    EXPECT_EQ(first_release(applied, 2 - clearance, false, true, 2.0).kind, EventKind::horizon)
        << "a wall holds it";
  }
}

TEST(DepartureTest, AConstantForceWithinTheBandHoldsForever) {
  const Flight<double> applied{0.0, 0.0, 0.5, {}, 0};
  EXPECT_THAT(first_release(applied, 0.5, true, true, 7.0), FieldsAre(EventKind::horizon, 7.0, _));
}

TEST(ZenoTail, IsTheSumOfItsHops) {
  for (const double e : {0.0, 0.1, 0.5, 0.99}) {
    for (const double friction : {0.0, 0.7, 1.9}) {
      double sum = 0;
      for (double speed = 3e-9; speed > 1e-30;) {
        const double up = speed / (2 + friction);
        const double height = speed * up / 2;
        const double down = std::sqrt(2 * height / (2 - friction));
        sum += up + down;
        speed = e * (2 - friction) * down;
      }
      EXPECT_NEAR(zeno_tail(3e-9, e, 2.0, friction), sum, 1e-12 * sum);
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
