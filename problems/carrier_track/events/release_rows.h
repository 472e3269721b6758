#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include "problems/carrier_track/events/search_rows.h"
#include "problems/carrier_track/flight/flight_rows.h"

namespace ricochet::carrier_track::inline events {

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
