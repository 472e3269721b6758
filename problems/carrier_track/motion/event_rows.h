#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include "problems/carrier_track/motion/flight_rows.h"

namespace ricochet::carrier_track::inline events {

/// See event.cpp.
template <class Row>
[[gnu::always_inline]] inline Row step_bound(const Row& value, const Row& slope, const Row& bound) {
  const Row root = stdx::sqrt(slope * slope + 2 * bound * value);
  const Row falling = 2 * value / (root - slope);
  return select(
      slope < 0.0, falling,
      select(bound > 0.0, (slope + root) / bound, Row(std::numeric_limits<double>::infinity())));
}

/// The search of event.cpp for several bodies at once. It is abandoned for a body that reaches the
/// horizon or needs many steps.
template <class Row, int harmonics>
class SearchRows {
  using Mask = MaskOf<Row>;
  static constexpr double epsilon = std::numeric_limits<double>::epsilon();
  static constexpr double infinity = std::numeric_limits<double>::infinity();

 public:
  SearchRows(const FlightRows<Row, harmonics>& start, const Row& direction, const Row& ahead,
             const Row& horizon)
      : there(start),
        start_(start.position),
        direction_(direction),
        ahead_(ahead),
        horizon_(horizon),
        speed_(most(direction * there.velocity, Row(0.0))),
        acceleration_(direction * there.acceleration(there.steady)),
        jerk_(direction * there.jerk()),
        snap_(direction * there.snap()),
        jerk_bound_(there.jerk_bound()),
        noise_(1e-9 * there.size(there.steady)) {}

  /// Finds events that bounds from the start prove to come first. Returns the moving bodies that
  /// need run_far().
  [[gnu::always_inline]] Mask run() {
    const Mask moving = direction_ != 0.0 && ahead_ > 0.0;
    begin_turn(moving);
    begin_arrival(moving && !turn);
    const Mask clear = turn || arrival;
    if (stdx::any_of(clear)) finish_from_first(clear);
    return moving && !clear;
  }

  /// Finds the events of all other bodies.
  void run_far(const Mask& moving) {
    begin_fast_arrival(moving);
    const Mask fast = arrival;
    if (stdx::any_of(fast)) finish_from_first(fast);
    const Mask rest = moving && !fast;
    if (stdx::any_of(rest)) advance_conservatively(rest);
  }

  FlightRows<Row, harmonics> there;
  Mask turn{false}, arrival{false};
  Row time = 0.0;
  Row evaluations = 0.0;

 private:
  /// Newton's method for turning points, the method of arrive() for arrivals. Abandons bodies that
  /// need more than `steps` steps.
  [[gnu::always_inline]] void finish(Mask turning, Mask arriving, int steps) {
    for (int i = 0; i < steps; ++i) {
      const Row speed = direction_ * there.velocity;
      const Row acceleration = direction_ * there.acceleration(there.steady);
      Row step = 0.0;
      Row error = infinity;
      if (stdx::any_of(turning)) {
        step = select(turning, least(-speed / acceleration, latest_ - time), step);
      }
      if (stdx::any_of(arriving)) arriving = approach(arriving, speed, acceleration, step, error);
      if (stdx::none_of(turning || arriving)) return;
      advance(step, turning || arriving);
      turning = turning &&
                !(jerk_bound_ * step * step <= -2 * epsilon * acceleration * time && time > 0.0);
      arriving = arriving && !(error <= epsilon * time);
    }
    turn = turn && !turning;
    arrival = arrival && !arriving;
  }

  [[gnu::always_inline]] void finish_from_first(const Mask& which) {
    advance(select(which, first_, Row(0.0)), which);
    upper_ = latest_;
    finish(turn, arrival, 6);
  }

  void advance_conservatively(Mask active) {
    const BoundRows<Row, harmonics> bounds(there, horizon_);
    Row least_step = bounds.shortest_step;
    Row step = step_bound(speed_, acceleration_, bounds.jerk);
    const Row sooner = select(jerk_ > 0.0, most(step, 3 * jerk_ / bounds.snap), step);
    step = select(speed_ <= 0.0, most(sooner, bounds.shortest_step), step);
    Mask found(false);
    for (int i = 0; i < 100 && stdx::any_of(active); ++i) {
      const FlightRows<Row, harmonics> here = there;
      const Row before = time;
      const Mask last = time + step >= horizon_;
      step = select(active, select(last, horizon_ - time, step), Row(0.0));
      advance(step, active);
      const Row distance = direction_ * (there.position - start_);
      const Mask far = active && distance > 2 * ahead_;
      if (stdx::any_of(far)) {
        there.restore(far, here);
        time = select(far, before, time);
      }
      const Mask reached = active && !far && distance >= ahead_;
      lower_ = select(reached, before, lower_);
      upper_ = select(reached, time, upper_);
      found = found || reached;
      const Row noise = 4 * epsilon * (speed_ + bounds.acceleration * time);
      Row speed = direction_ * there.velocity;
      const Row acceleration = direction_ * there.acceleration(there.steady);
      const Mask slow = speed <= noise;
      const Mask turned = active && !far && !reached && !last && slow && acceleration <= 0.0;
      turn = turn || turned;
      active = active && !reached && !turned && (far || !last);
      speed = select(slow, most(speed, Row(0.0)), speed);
      Row next = most(step_bound(speed, acceleration, bounds.jerk), epsilon * time);
      least_step =
          select(active && !far, select(slow, 2 * least_step, bounds.shortest_step), least_step);
      next = select(slow, most(next, least_step), next);
      step = select(far, step / 2, next);
    }
    arrival = arrival || found;
    jerk_bound_ = select(found, bounds.jerk, jerk_bound_);
    finish(Mask(false), found, 100);
  }

  [[gnu::always_inline]] void begin_turn(const Mask& moving) {
    const Row certain = acceleration_ * acceleration_ - 2 * jerk_bound_ * speed_;
    turn = moving && acceleration_ < -noise_ && speed_ > 0.0 && certain > 0.0;
    if (stdx::none_of(turn)) return;
    const Row inverse = -1.0 / acceleration_;
    const Row plain = speed_ * inverse;
    latest_ = 2 * plain;
    const Mask near = latest_ < horizon_ && speed_ * plain < ahead_;
    if (stdx::any_of(turn && !near)) {
      const Row latest = 2 * speed_ / (stdx::sqrt(certain) - acceleration_);
      turn = turn && (near || (latest < horizon_ && 0.5 * speed_ * latest < ahead_));
      latest_ = select(near, latest_, latest);
    }
    const Row b = 0.5 * jerk_ * plain * inverse;
    const Row c = snap_ * plain * plain * inverse / 6;
    const Row guess = plain * (1.0 + b + c + b * (2 * b + 5 * (b * b + c)));
    first_ = select(guess > 0.0 && guess < latest_, guess, plain);
  }

  [[gnu::always_inline]] void begin_arrival(const Mask& moving) {
    const Row square = speed_ * speed_ + 2 * acceleration_ * ahead_;
    arrival = moving && square > 0.0;
    if (stdx::none_of(arrival)) return;
    const Row plain = 2 * ahead_ / (speed_ + stdx::sqrt(square));
    const Row latest = 1.25 * plain;
    const Row slow = speed_ + latest * (acceleration_ - latest * jerk_bound_ / 2);
    const Row near = latest * (speed_ + latest * (acceleration_ / 2 - latest * jerk_bound_ / 6));
    arrival = arrival && slow > 0.0 && near > ahead_ && latest < horizon_ &&
              (speed_ > 0.0 || acceleration_ > noise_);
    const Row miss =
        plain * (speed_ + plain * (acceleration_ / 2 + plain * (jerk_ / 6 + plain * snap_ / 24))) -
        ahead_;
    const Row guess =
        plain - miss / (speed_ + plain * (acceleration_ + plain * (jerk_ / 2 + plain * snap_ / 6)));
    latest_ = select(arrival, latest, latest_);
    first_ = select(arrival, select(guess > 0.0 && guess < latest, guess, plain), first_);
  }

  /// For bodies whose forces pass through whole periods on the way but cannot stop the body.
  void begin_fast_arrival(const Mask& unclear) {
    const Row latest = 2 * ahead_ / speed_;
    Row slowest = speed_ + least(direction_ * there.steady, Row(0.0)) * latest;
    Row mean = speed_;
    for (std::size_t h = 0; h < harmonics; ++h) {
      const Row amplitude = there.amplitude(h);
      const Row sine = direction_ * there.sine[h];
      const Row drop = (amplitude + sine) / there.frequency[h];
      const Mask quick = drop < amplitude * latest;
      slowest -= select(quick, drop, amplitude * latest);
      mean -= select(quick, sine / there.frequency[h], Row(0.0));
    }
    const Mask fast =
        unclear && speed_ > 0.0 && latest < horizon_ && slowest > 0.0 && slowest * latest > ahead_;
    const Row guess = ahead_ / mean;
    arrival = arrival || fast;
    latest_ = select(fast, latest, latest_);
    first_ = select(fast, select(guess > 0.0 && guess < latest, guess, latest / 2), first_);
  }

  /// One step towards the walls. Returns the lanes that need more steps.
  [[gnu::always_inline]] Mask approach(const Mask& arriving, const Row& speed,
                                       const Row& acceleration, Row& step_of_all,
                                       Row& error_of_all) {
    const Row gap = ahead_ - direction_ * (there.position - start_);
    const Mask before = gap > 0.0;
    lower_ = select(before, time, lower_);
    upper_ = select(before, upper_, time);
    const Row straight = gap / speed;
    const Row bend = acceleration * straight / speed;
    Row step = straight * (1.0 - bend / 2 + bend * bend / 2);
    Row error = jerk_bound_ * stdx::abs(step * step * step) / (6 * speed) +
                stdx::abs(straight * bend * bend * bend);
    const Mask bent = !(speed > 0.0 && stdx::abs(bend) < 1e-2);
    if (stdx::any_of(arriving && bent)) {
      const Row end = stdx::sqrt(speed * speed + 2 * acceleration * gap);
      const Row curved = 2 * gap / (speed + end);
      step = select(bent, curved, step);
      error = select(bent, jerk_bound_ * stdx::abs(curved * curved * curved) / (6 * end), error);
    }
    const Mask arrived =
        stdx::abs(step) <= 2 * epsilon * time || upper_ - lower_ <= 2 * epsilon * upper_;
    const Row next = time + step;
    const Mask inside = next > lower_ && next < upper_;
    step = select(inside, step, lower_ + 0.5 * (upper_ - lower_) - time);
    error = select(inside, error, Row(infinity));
    const Mask going = arriving && !arrived;
    step_of_all = select(going, step, step_of_all);
    error_of_all = select(going, error, error_of_all);
    return going;
  }

  /// Lets `t` [s] pass for the bodies in `which`. The others do not change; even a zero keeps its
  /// sign.
  [[gnu::always_inline]] void advance(const Row& t, const Mask& which) {
    if (stdx::all_of(which)) {
      there.advance(t);
    } else {
      const FlightRows<Row, harmonics> here = there;
      there.advance(t);
      there.restore(!which, here);
    }
    time += t;
    evaluations += select(which, 1.0, Row(0.0));
  }

  Row start_, direction_, ahead_, horizon_;
  Row speed_, acceleration_, jerk_, snap_, jerk_bound_, noise_;
  Row first_ = 0.0;
  Row latest_ = 0.0;
  Row lower_ = 0.0;
  Row upper_ = 0.0;
};

/// The search of next_release() for several bodies at rest at once.
template <class Row, int harmonics>
class ReleaseRows {
  using Mask = MaskOf<Row>;
  static constexpr double epsilon = std::numeric_limits<double>::epsilon();
  static constexpr double infinity = std::numeric_limits<double>::infinity();

 public:
  /// `applied` does not include friction.
  ReleaseRows(const FlightRows<Row, harmonics>& applied, const Row& friction, const Row& horizon)
      : applied_(applied), friction_(friction), horizon_(horizon), bounds_(applied, horizon) {}

  /// Searches for the bodies in `rest`, in the directions that the walls allow.
  void run(const Mask& rest, const Mask& may_rise, const Mask& may_fall) {
    const Mask still = bounds_.jerk <= 0.0;
    end(rest && still, horizon_, 0.0);
    Mask active = rest && !still;
    Row now = 0.0;
    Row least_step = bounds_.shortest_step;
    while (stdx::any_of(active)) {
      const auto [push, slope] = applied_at(now, active);
      evaluations += select(active, 1.0, Row(0.0));
      Row step = infinity;
      Mask at_the_edge(false);
      const Mask rises = look(active && may_rise, friction_ - push, -slope, step, at_the_edge);
      end(rises, now, 1.0);
      active = active && !rises;
      const Mask falls = look(active && may_fall, friction_ + push, slope, step, at_the_edge);
      end(falls, now, -1.0);
      active = active && !falls;
      least_step = select(at_the_edge, 2 * least_step, bounds_.shortest_step);
      step = select(at_the_edge, most(step, least_step), step);
      const Mask over = active && (now >= horizon_ || step == infinity);
      end(over, horizon_, 0.0);
      active = active && !over;
      now = least(Row(now + most(step, Row(epsilon * now))), horizon_);
    }
  }

  Row time = 0.0;
  Row direction = 0.0;  ///< of the release; 0: none before the horizon
  Row evaluations = 0.0;

 private:
  struct Force {
    Row acceleration, jerk;
  };

  /// See Flight::applied_at; for the bodies in `which`.
  Force applied_at(const Row& t, const Mask& which) const {
    Force push{applied_.steady, 0.0};
    for (std::size_t h = 0; h < harmonics; ++h) {
      const Row angle = applied_.frequency[h] * t;
      Row c = 1.0;
      Row s = 0.0;
      for (std::size_t i = 0; i < Row::size(); ++i) {
        if (!which[i] || angle[i] == 0) continue;
        c[i] = std::cos(double(angle[i]));
        s[i] = std::sin(double(angle[i]));
      }
      push.acceleration += applied_.cosine[h] * c - applied_.sine[h] * s;
      push.jerk -= applied_.frequency[h] * (applied_.cosine[h] * s + applied_.sine[h] * c);
    }
    return push;
  }

  /// Returns the bodies that leave in one direction now; lowers `step` to the time until others may
  /// leave.
  Mask look(const Mask& which, const Row& reserve, const Row& slope, Row& step,
            Mask& at_the_edge) const {
    const Row sum = bounds_.acceleration + friction_;
    const Mask near = reserve <= 4 * epsilon * sum;
    const Mask leaves =
        which && (reserve < -1e-9 * sum || (near && slope < -(4 * epsilon * bounds_.jerk)));
    const Row bound = step_bound(most(reserve, Row(0.0)), slope, bounds_.snap);
    step = select(which && !leaves, least(step, bound), step);
    at_the_edge = at_the_edge || (which && !leaves && near);
    return leaves;
  }

  void end(const Mask& which, const Row& when, double where_to) {
    time = select(which, when, time);
    direction = select(which, where_to, direction);
  }

  const FlightRows<Row, harmonics>& applied_;
  Row friction_, horizon_;
  BoundRows<Row, harmonics> bounds_;
};

}  // namespace ricochet::carrier_track::inline events
