#pragma once

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_step_result.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "src/core/bracketed_root.h"

// NOTE: plain C++17, like flight_method.h and dense_flight.h: Boost.Odeint's rosenbrock4 does not
// compile as C++20, and scene.h needs concepts.
namespace ricochet::carrier_track::inline scene {

template <class Scalar>
struct BasicScene;

}  // namespace ricochet::carrier_track::inline scene

namespace ricochet::carrier_track::inline reference_integrators {

struct State {
  double position;  ///< [m]
  double velocity;  ///< [m/s]
};

/// The forces of the driver plate with a speed profile, and the plate's angle from knot to knot.
struct ProfilePlate {
  struct Knot {
    double time, alpha, omega;
  };
  std::vector<Knot> knots;
  double steady = 0;         // [m/s^2]
  double square = 0;         // [m], times omega^2
  double cosine = 0;         // [m/s^2], times cos(alpha)
  double square_cosine = 0;  // [m], times omega^2 cos(alpha)
  double sine = 0;           // [m/s^2], times sin(alpha)
  double slider = 0;         // [m], times -omega' sin(alpha)

  double applied(double time) const;
  double applied_rate(double time) const;
  double strongest() const;

 private:
  struct Plate {
    double alpha, omega, slope;
  };
  Plate plate(double time) const;
};

/// The right-hand side of equation (31) between impacts, as accelerations [m/s^2].
struct Forces {
  double steady = 0;
  double turning = 0;  ///< amplitude, with angle omega t + phase
  double omega = 0;    ///< [rad/s]
  double phase = 0;    ///< [rad]
  double disturbance = 0;
  double disturbance_frequency = 0;  ///< [rad/s]
  double disturbance_phase = 0;      ///< [rad]
  double friction = 0;               ///< >= 0, set-valued at rest
  ProfilePlate profile;              ///< replaces steady and turning if it has knots

  /// All forces except contact and friction, at `time` [s].
  double applied(double time) const {
    double sum = profile.knots.empty() ? steady : profile.applied(time);
    if (turning != 0) sum += turning * std::cos(omega * time + phase);
    if (disturbance != 0)
      sum += disturbance * std::cos(disturbance_frequency * time + disturbance_phase);
    return sum;
  }

  /// Its derivative with respect to time [m/s^3].
  double applied_rate(double time) const {
    return (profile.knots.empty() ? 0.0 : profile.applied_rate(time)) -
           turning * omega * std::sin(omega * time + phase) -
           disturbance * disturbance_frequency *
               std::sin(disturbance_frequency * time + disturbance_phase);
  }

  /// Bound on the magnitude of applied() [m/s^2].
  double strongest() const;

  /// [s]; of the time-dependent forces, infinite if there are none.
  double shortest_period() const;
};

/// The forces of a valid scene.
Forces forces_of(const BasicScene<double>& scene);

// NOTE: plain C++17, like forces.h.

/// The force of two compliant walls divided by the mass [m/s^2], as a function of the state: the
/// laws of contact_law.h, without events.
struct WallForce {
  struct Slopes {
    double by_position;  ///< [1/s^2]
    double by_velocity;  ///< [1/s]
  };

  double lower = 0, upper = 0;                  ///< [m], the walls; upper may be infinite
  double stiffness = 0;                         ///< K/m
  double exponent = 1;                          ///< n
  bool viscous = false;                         ///< Kelvin-Voigt
  double lower_damping = 0, upper_damping = 0;  ///< D, or C/m [1/s] if viscous
  double speed = 1;                             ///< [m/s], v0 of the law

  /// Penetration [m], <= 0 between the walls.
  double depth(double position) const { return std::max(lower - position, position - upper); }

  double operator()(const State& state) const {
    const double d = depth(state.position);
    if (!(d > 0)) return 0;
    const int outward = state.position < lower ? +1 : -1;
    const double rate = -outward * state.velocity;
    if (viscous) return outward * std::max(0.0, stiffness * d + damping(outward) * rate);
    return outward * spring(d) * (1 + damping(outward) / speed * rate);
  }

  Slopes slopes(const State& state) const {
    const double d = depth(state.position);
    if (!(d > 0)) return {0, 0};
    const int outward = state.position < lower ? +1 : -1;
    const double rate = -outward * state.velocity;
    if (viscous) {
      const bool presses = stiffness * d + damping(outward) * rate > 0;
      return presses ? Slopes{-stiffness, -damping(outward)} : Slopes{0, 0};
    }
    const double factor = damping(outward) / speed;
    return {-exponent * spring(d) / d * (1 + factor * rate), -factor * spring(d)};
  }

 private:
  double damping(int outward) const { return outward > 0 ? lower_damping : upper_damping; }

  double spring(double d) const {
    if (exponent == 1.5) return stiffness * d * std::sqrt(d);
    return exponent == 1 ? stiffness * d : stiffness * std::pow(d, exponent);
  }
};

/// The walls of a valid scene with compliant walls; `speed` is its contact_speed, or 1 m/s.
WallForce wall_force_of(const BasicScene<double>& scene);

/// The walls that end a flight [m]; the upper one may be at infinity.
struct WallPositions {
  double lower, upper;
};

/// What a flight method needs to know of a scene.
struct FlightSetting {
  Forces forces;
  WallPositions gap;
  double window;  ///< [s]
  double length;  ///< [m]; absolute tolerances are the relative one times this (and [m/s] alike)
};

/// `length` is the width of the gap; if it is infinite, the start's height above the lower wall, or
/// 1 m for a start on that wall.
FlightSetting flight_setting(const BasicScene<double>& scene);

/// A flight without impact, which starts at rest or moves in `direction`. With friction it must end
/// at zero velocity; without, the body may turn and continue.
struct Leg {
  double start;    ///< [s] from the start of the window
  State state;     ///< within the gap
  int direction;   ///< +1 or -1
  double longest;  ///< [s], > 0; the rest of the window
};

enum class Finish { lower_wall, upper_wall, turn, limit };

struct Landing {
  Finish finish;
  double duration;  ///< [s] from the start of the leg
  State state;      ///< as integrated, so slightly off the wall or off zero velocity
};

/// An integrator with event location, for smooth motion between impacts. One object serves all legs
/// of a run, so that it keeps its memory and history.
class FlightMethod {
 public:
  virtual ~FlightMethod() = default;

  /// Throws std::runtime_error if the method fails or needs more than most_steps in all.
  virtual Landing fly(const Leg& leg) = 0;

  /// Evaluations of the forces so far.
  virtual std::int64_t evaluations() const = 0;
};

/// A method that takes more steps than this in a run is stopped.
inline constexpr std::int64_t most_steps = 1'000'000;

/// The point where f, not positive at `lower` and positive at `upper`, becomes positive: at most a
/// few roundings of `upper` behind a sign change. If there are several sign changes, it is any of
/// them. f(result) may be 0.
template <class Function>
double rise(Function f, double lower, double upper) {
  const double at_lower = f(lower);
  if (at_lower >= 0) return lower;
  const double width = 4 * std::numeric_limits<double>::epsilon() * upper;
  return bracketed_root(f, lower, upper, at_lower, f(upper),
                        [width](double a, double b) { return b - a <= width; })
      .second;
}

struct Slope {
  double value, slope;
};

/// The point where f, positive at `lower` or right behind it, and not at `upper`, has fallen to
/// zero, to a few roundings of `upper`; `lower` if f is nowhere positive. f(time) returns a Slope.
/// Newton's iteration in a bracket, from the root of a parabola through both ends.
///
/// NOTE: an integration with event location spends most of its time here; for these smooth, nearly
/// parabolic functions this needs half the time of toms748_solve.
template <class Function>
double fall(Function f, double lower, double upper) {
  const double width = 4 * std::numeric_limits<double>::epsilon() * upper;
  const double length = upper - lower;
  const auto [start, slope_at_start] = f(lower);
  const double bend = (f(upper).value - start - slope_at_start * length) / (length * length);
  const double root = std::sqrt(slope_at_start * slope_at_start - 4 * bend * start);
  double next = lower + (slope_at_start > 0 ? -0.5 * (slope_at_start + root) / bend
                                            : 2 * start / (root - slope_at_start));
  double time = upper;
  while (upper - lower > width) {
    if (!(next > lower && next < upper)) next = lower + 0.5 * (upper - lower);
    const bool converged = std::abs(next - time) <= width;
    time = next;
    if (converged) break;
    const auto [value, slope] = f(time);
    (value > 0 ? lower : upper) = time;
    next = time - value / slope;
  }
  return time;
}

/// How far `position` is from the wall in `direction` [m], negative behind it.
inline double distance_ahead(const WallPositions& gap, int direction, double position) {
  return direction > 0 ? gap.upper - position : position - gap.lower;
}

/// The first event of a step from `begin` to `end` [s] of the dense output `path(time)`, for motion
/// in `direction`, which changes at velocity zeros, under the acceleration `pull(time)`. Events are
/// detected by the signs of velocity and distance at both ends; in a step whose velocity changes
/// sign, also at the velocity zero. So an event that starts and ends between two velocity zeros of
/// one step is missed.
template <class Path, class Pull>
std::optional<Landing> first_event(const WallPositions& gap, bool turn_ends, int& direction,
                                   double begin, double end, const State& at_end, Path path,
                                   Pull pull) {
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
Landing fly_dense(Stepper& stepper, const System& system, Pull pull, const WallPositions& gap,
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

// NOTE: plain C++17, like forces.h.

/// A scene as one smooth, possibly stiff, equation of motion: what a penalty method integrates.
struct PenaltySystem {
  Forces forces;  ///< without friction
  WallForce wall;
  double window;  ///< [s]
  double length;  ///< [m]; absolute tolerances are the relative one times this (and [m/s] alike)

  double acceleration(double time, const State& state) const {
    return forces.applied(time) + wall(state);
  }
};

/// An integrator that advances a PenaltySystem from its start, step by step.
class StepMethod {
 public:
  virtual ~StepMethod() = default;

  /// Takes one accepted step, which advances `time` [s] and `state`. They must be the result of the
  /// last step, or the start. The last step ends at the window's end or beyond. Throws
  /// std::runtime_error if the method fails.
  virtual void step(double& time, State& state) = 0;

  /// Evaluations of the acceleration so far.
  virtual std::int64_t evaluations() const = 0;
};

// NOTE: plain C++17, like forces.h.

/// Takes one accepted step of a controlled stepper of Boost.Odeint, from `time` to at most `end`
/// [s]. `step` [s] is its last proposal. Throws std::runtime_error if no step is small enough.
template <class Stepper, class System, class Vector>
void take_step(Stepper& stepper, const System& system, Vector& state, double& time, double& step,
               double end) {
  double tried = std::min(step, end - time);
  while (stepper.try_step(system, state, time, tried) == boost::numeric::odeint::fail) {
    if (!(time + tried > time)) throw std::runtime_error("no step is small enough");
  }
  step = tried;
}

}  // namespace ricochet::carrier_track::inline reference_integrators
