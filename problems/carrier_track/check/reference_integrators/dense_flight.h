#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "problems/carrier_track/check/reference_integrators/flight_method.h"
#include "problems/carrier_track/check/reference_integrators/root.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// How far `position` is from the wall in `direction` [m], negative behind it.
inline double distance_ahead(const Bias& gap, int direction, double position) {
  return direction > 0 ? gap.upper - position : position - gap.lower;
}

/// The first event of a step from `begin` to `end` [s] of the dense output `path(time)`, for motion
/// in `direction`, which changes at velocity zeros, under the acceleration `pull(time)`. Events are
/// detected by the signs of velocity and distance at both ends; in a step whose velocity changes
/// sign, also at the velocity zero. So an event that starts and ends between two velocity zeros of
/// one step is missed.
template <class Path, class Pull>
std::optional<Landing> first_event(const Bias& gap, bool turn_ends, int& direction, double begin,
                                   double end, const State& at_end, Path path, Pull pull) {
  const auto reach = [&](double from, double to) {
    const auto distance = [&](double t) {
      const State state = path(t);
      return Slope{distance_ahead(gap, direction, state.position), -direction * state.velocity};
    };
    const double time = fall(distance, from, to);
    return Landing{direction > 0 ? Finish::upper_wall : Finish::lower_wall, time, path(time)};
  };
  double from = begin;
  if (direction * at_end.velocity < 0) {
    const auto speed = [&](double t) {
      return Slope{direction * path(t).velocity, direction * pull(t)};
    };
    const double turn = fall(speed, begin, end);
    const State at_turn = path(turn);
    if (distance_ahead(gap, direction, at_turn.position) < 0) return reach(begin, turn);
    if (turn_ends) return Landing{Finish::turn, turn, at_turn};
    direction = -direction;
    from = turn;
  }
  if (distance_ahead(gap, direction, at_end.position) < 0) return reach(from, end);
  return std::nullopt;
}

/// Flies `leg` with a dense-output stepper of Boost.Odeint, whose state type is `Vector`, under the
/// acceleration `pull(time)`, time [s] from the start of the leg. `workspace` holds two numbers.
/// `step` is the first step tried [s] and becomes the last one that the stepper proposes; `steps`
/// is incremented.
template <class Vector, class Stepper, class System, class Pull>
Landing fly_dense(Stepper& stepper, const System& system, Pull pull, const Bias& gap,
                  bool turn_ends, const Leg& leg, Vector& workspace, double& step,
                  std::int64_t& steps) {
  const auto path = [&](double time) {
    stepper.calc_state(time, workspace);
    return State{workspace[0], workspace[1]};
  };
  workspace[0] = leg.state.position;
  workspace[1] = leg.state.velocity;
  stepper.initialize(workspace, 0.0, step);
  int direction = leg.direction;
  for (;;) {
    if (++steps > most_steps) throw std::runtime_error("more than 1000000 steps");
    stepper.do_step(system);
    const bool last = stepper.current_time() >= leg.longest;
    const double end = last ? leg.longest : stepper.current_time();
    const auto& state = stepper.current_state();
    const State at_end = last ? path(end) : State{state[0], state[1]};
    const auto landing =
        first_event(gap, turn_ends, direction, stepper.previous_time(), end, at_end, path, pull);
    if (landing || last) {
      step = stepper.current_time_step();
      return landing ? *landing : Landing{Finish::limit, end, at_end};
    }
  }
}

/// The longest step [s]: half a period. Two velocity zeros in one step, which first_event would
/// miss, are then rare, and the error estimate cannot mistake a whole period for a constant force.
inline double longest_step(const Forces& forces, double window) {
  return std::min(window, 0.5 * forces.shortest_period());
}

}  // namespace ricochet::carrier_track::inline reference_integrators
