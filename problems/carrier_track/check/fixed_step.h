#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "problems/carrier_track/check/flight_method.h"
#include "problems/carrier_track/check/integrator.h"
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

}  // namespace ricochet::carrier_track::inline reference_integrators
