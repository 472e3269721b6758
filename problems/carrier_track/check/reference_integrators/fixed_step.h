#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "problems/carrier_track/reference_integrators/forces.h"
#include "problems/carrier_track/reference_integrators/integrator.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// A run with more fixed steps than this is not started.
inline constexpr double most_fixed_steps = 1e8;

/// Equal steps that fill a window, none longer than asked for.
struct StepPlan {
  std::int64_t count;
  double length;  ///< [s]
};

/// False, with the failure told, for more than most_fixed_steps.
bool plan_steps(const Scene& scene, double longest, StepPlan& plan, Outcome& outcome);

/// Where a velocity is after friction has worked on it for a step: towards zero by `change` [m/s],
/// but not beyond. This is implicit, set-valued friction: a body sticks while the applied force is
/// no larger.
inline double after_friction(double velocity, double change) {
  return std::copysign(std::max(std::abs(velocity) - change, 0.0), velocity);
}

/// What an explicit fixed-step method does between walls; `direction` is that of motion or, from
/// rest, of departure.
/// State step(const Forces&, double time, const State&, int direction, double length);
///
/// Simulates a valid scene as is commonly done: a step, and if it ends behind a wall, the body is
/// put on the wall, with its velocity turned round times the restitution, at the end of the step.
/// At rest it sticks while friction and wall hold it, checked at the start of every step. It rests
/// on a wall, unless the force leads away, once the rebound is at most slowest_rebound or what the
/// force changes in a step, so that its hop would be lost within two steps.
/// NOTE: a step that ends behind the wall makes the approach faster, by about half of what the
/// force changes in a step. With e near 1 the Zeno sequences of an explicit method can therefore
/// chatter for ever. That is how this common way fails, and no rule here hides it.
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
    if (speed < 0) continue;  // it came back within the step
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

}  // namespace ricochet::carrier_track::inline reference_integrators
