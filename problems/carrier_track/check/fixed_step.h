#pragma once

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_step_result.hpp>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/check/wall_forces.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// A run with more fixed steps than this is not started.
inline constexpr double most_fixed_steps = 1e8;

/// Equal steps that fill a window, none longer than requested.
struct StepPlan {
  std::int64_t count;
  double length;  ///< [s]
};

/// Returns false and sets the failure for more than most_fixed_steps.
bool plan_steps(const Scene& scene, double longest, StepPlan& plan, Outcome& outcome);

/// The velocity after friction has acted for a step: it moves towards zero by `change` [m/s], but
/// not beyond. This is implicit, set-valued friction: a body sticks while the applied force is no
/// larger.
inline double after_friction(double velocity, double change) {
  return std::copysign(std::max(std::abs(velocity) - change, 0.0), velocity);
}

/// Simulates a valid scene in the common way, with an explicit fixed-step method between walls:
/// State step(const Forces&, double time, const State&, int direction, double length);
/// `direction` is that of motion or, from rest, of departure.
///
/// If a step ends behind a wall, the body is put on the wall at the end of the step, and its
/// velocity is reversed and multiplied by the restitution. At rest the body sticks while friction
/// and wall hold it, checked at the start of every step. It rests on a wall, unless the force leads
/// away, once the rebound is at most slowest_rebound or the change of velocity by the force in a
/// step, so that its flight would end within two steps.
/// NOTE: a step that ends behind the wall makes the approach faster, by about half of that change
/// of velocity. With e near 1 the Zeno sequences of an explicit method can therefore chatter
/// forever. This is a known failure of the common way, and no rule here hides it.
template <class Step>
Outcome run_with_reflection(const Scene& scene, double longest, std::int64_t evaluations_a_step,
                            Step step) {
  Outcome outcome;
  StepPlan plan{};
  if (!plan_steps(scene, longest, plan, outcome)) return outcome;
  const Forces forces = forces_of(scene);
  const double h = plan.length;
  State state{scene.start_position, scene.start_velocity};
  double time = 0;
  for (std::int64_t i = 0; i < plan.count; ++i) {
    time = static_cast<double>(i) * h;
    int direction = (state.velocity > 0) - (state.velocity < 0);
    if (direction == 0) {
      const double push = forces.applied(time);
      ++outcome.force_evaluations;
      if (push > forces.friction && state.position < scene.wall_upper) direction = +1;
      if (push < -forces.friction && state.position > scene.wall_lower) direction = -1;
    }
    time = static_cast<double>(i + 1) * h;
    if (direction == 0) continue;
    state = step(forces, time - h, state, direction, h);
    outcome.force_evaluations += evaluations_a_step;
    const int behind = (state.position > scene.wall_upper) - (state.position < scene.wall_lower);
    if (behind == 0) continue;
    state.position = behind > 0 ? scene.wall_upper : scene.wall_lower;
    const double speed = behind * state.velocity;
    if (speed < 0) continue;  // it was back within the step
    if (outcome.impacts.size() == most_impacts) {
      outcome.failure = "more than 1000000 impacts";
      break;
    }
    outcome.impacts.push_back({time, behind > 0 ? Wall::upper : Wall::lower, speed});
    const double e = behind > 0 ? upper_restitution(scene) : lower_restitution(scene);
    const double press = behind * forces.applied(time);
    ++outcome.force_evaluations;
    const bool rests = press >= -forces.friction &&
                       e * speed <= std::max(slowest_rebound, h * (press + forces.friction));
    state.velocity = rests ? 0.0 : -behind * e * speed;
  }
  outcome.end = {time, state.position, state.velocity};
  outcome.finished = outcome.failure.empty();
  return outcome;
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
