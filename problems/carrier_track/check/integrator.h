#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "problems/carrier_track/check/wall_forces.h"
#include "problems/carrier_track/counting/recording.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"
#include "src/core/numeric.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// The result of a numerical method for a scene.
struct Outcome {
  std::vector<Impact> impacts;         ///< all detected impacts, slow ones too
  Sample end{};                        ///< where it ended; the end of the window if finished
  std::int64_t force_evaluations = 0;  ///< event-driven: of the closed-form flight
  bool finished = false;
  std::string failure;  ///< why it did not finish, e.g. too many steps

  // For penalty methods only, which enter the walls.
  double deepest = 0;  ///< [m] behind a wall; infinite: more than the gap, which ended the run
  /// [m/s]; the largest excess of the speed after a contact over that before it and the possible
  /// increase by the applied forces in between. No wall gives energy: > 0 is the method's error.
  /// Empty if no contact has ended.
  std::optional<double> gained;
};

/// A method for the whole hybrid motion: flights, impacts, sticking and the ends of Zeno sequences.
/// `run` takes a valid scene and a control parameter > 0. It never throws, and it always ends: a
/// run with too many steps or impacts is not finished. Runs share no state.
struct Integrator {
  std::string name;
  std::string version;
  std::string control;  ///< meaning and unit of the number given to `run`
  std::function<Outcome(const Scene&, double control)> run;
};

/// The project's own event-driven simulator first, then the methods compared with it.
std::vector<Integrator> all_integrators();

/// The same event-driven simulator first, then methods that integrate straight through the contacts
/// of compliant walls. They refuse scenes with hard walls or with friction.
std::vector<Integrator> penalty_integrators();

/// Names of the integrators missing from this build, which has no SUNDIALS.
std::vector<std::string> missing_integrators();

/// A rebound slower than this [m/s] against a pressing force ends a Zeno sequence for every method
/// here except the event-driven one, which sums it in closed form (resting_speed). Under the forces
/// of these scenes it rises 1e-12 m, about the rounding of a position in a track.
inline constexpr double slowest_rebound = 1e-6;

/// A run with more impacts than this is not finished.
inline constexpr std::size_t most_impacts = 1'000'000;

// One method per source file; integrator.cpp lists them.

/// ImpactModel: flights in closed form, events by conservative advancement. For compliant walls the
/// CompliantModel at its tightest tolerance, 1e-12. Ignores the control parameter.
Integrator event_driven();

/// Boost.Odeint's Dormand-Prince 5(4), events on its dense output.
Integrator odeint_dopri5();

/// Boost.Odeint's Rosenbrock method of order 4, events on its dense output.
Integrator odeint_rosenbrock4();

/// SUNDIALS CVODE, Adams-Moulton of order 1 to 12, with its own rootfinding.
Integrator cvode_adams();

/// SUNDIALS CVODE, backward differentiation of order 1 to 5, with its own rootfinding.
Integrator cvode_bdf();

/// Fixed steps; walls are detected at the end of a step.
Integrator semi_implicit_euler();
Integrator runge_kutta_4();

/// Moreau-Jean time-stepping, theta = 1/2: contact and friction as impulses at velocity level.
Integrator moreau_jean();

/// Penalty methods (penalty.h): integrate straight through the contacts of compliant walls. CVODE
/// iterates Adams-Moulton by fixed point, as for non-stiff motion, and BDF by Newton.
Integrator penalty_semi_implicit_euler();
Integrator penalty_runge_kutta_4();
Integrator penalty_odeint_dopri5();
Integrator penalty_odeint_rosenbrock4();
Integrator penalty_cvode_adams();
Integrator penalty_cvode_bdf();

/// The errors of an outcome relative to a reference for the same scene.
///
/// An impact is fast if the scene counts it: its speed is above `counting_limit`. Fast impacts are
/// matched in order: the next two of both lists are partners if they are on the same wall and no
/// further apart than half the mean time between the reference's fast impacts; otherwise the
/// earlier one has no partner. A partner needs only half that speed, so that an impact just above
/// the limit still has one that is slightly slower.
struct Accuracy {
  int missed = 0;    ///< fast impacts of the reference without a partner
  int spurious = 0;  ///< fast impacts of the outcome without a partner
  int matched = 0;   ///< pairs before the paths diverge, at the first impact counted above
  /// Largest difference of the times of those pairs [s]; empty without a pair.
  std::optional<double> impact_time_error;
  int count_difference = 0;       ///< fast impacts of the outcome minus those of the reference
  double end_position_error = 0;  ///< [m], at the end of the window
};

/// `outcome` and `reference` are finished runs of the valid `scene`. The rule `impacts` is applied
/// whatever the scene's rule: outcomes contain no peaks.
Accuracy compare(const Scene& scene, const Outcome& outcome, const Outcome& reference);

/// The number of impacts of `outcome` above the scene's `counting_limit`.
int collisions(const Scene& scene, const Outcome& outcome);

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

/// Simulates a valid scene with the flights of `method`, made for the same scene. The discrete part
/// of the motion is the same for all such methods:
/// - Impact: the velocity is reversed and multiplied by the restitution, and the method restarted.
/// - Rest: on a wall, unless the force leads away, once the rebound is at most slowest_rebound or
///   its height is lost in the rounding of the position; in the gap if the velocity is zero and
///   friction holds the body.
/// - Departure: when the applied force exceeds what friction and wall hold, detected by a sign
///   change between samples 1/64 of the shortest period apart and located to rounding. An excess
///   that lasts less than that is missed.
Outcome run_with_located_events(const Scene& scene, FlightMethod& method);

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

}  // namespace ricochet::carrier_track::inline reference_integrators
