#include "problems/carrier_track/check/reference_integrators/fixed_step.h"
#include "problems/carrier_track/check/reference_integrators/methods.h"
#include "problems/carrier_track/check/reference_integrators/penalty.h"

namespace ricochet::carrier_track::inline reference_integrators {
namespace {

/// Classical Runge-Kutta; its two middle stages need one evaluation, since the forces depend only
/// on time. Friction keeps the sign that it has at the start of the step. A body under friction
/// whose velocity has changed sign by the end is at rest there: with the wrong sign it would gain
/// energy.
State step(const Forces& forces, double time, const State& state, int direction, double length) {
  const double friction = direction * forces.friction;
  const double a1 = forces.applied(time) - friction;
  const double a23 = forces.applied(time + 0.5 * length) - friction;
  const double a4 = forces.applied(time + length) - friction;
  const double v1 = state.velocity;
  const double v2 = v1 + 0.5 * length * a1;
  const double v3 = v1 + 0.5 * length * a23;
  const double v4 = v1 + length * a23;
  State next{state.position + length / 6 * (v1 + 2 * v2 + 2 * v3 + v4),
             v1 + length / 6 * (a1 + 4 * a23 + a4)};
  if (forces.friction > 0 && direction * next.velocity < 0) next.velocity = 0;
  return next;
}

/// The same for a force that also depends on the state: four evaluations.
State penalty_step(const PenaltySystem& system, double time, const State& state, double length) {
  const double half = 0.5 * length;
  const double v1 = state.velocity;
  const double push = system.forces.applied(time + half);  // of both middle stages
  const double a1 = system.acceleration(time, state);
  const double v2 = v1 + half * a1;
  const double a2 = push + system.wall({state.position + half * v1, v2});
  const double v3 = v1 + half * a2;
  const double a3 = push + system.wall({state.position + half * v2, v3});
  const double v4 = v1 + length * a3;
  const double a4 = system.acceleration(time + length, {state.position + length * v3, v4});
  return {state.position + length / 6 * (v1 + 2 * v2 + 2 * v3 + v4),
          v1 + length / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
}

}  // namespace

Integrator runge_kutta_4() {
  return {"runge-kutta-4", "ricochet " RICOCHET_VERSION, "step [s]",
          [](const Scene& scene, double longest) {
            return run_with_reflection(scene, longest, 3, step);
          }};
}

Integrator penalty_runge_kutta_4() {
  return equal_step_penalty("runge-kutta-4", "ricochet " RICOCHET_VERSION, 4, penalty_step);
}

}  // namespace ricochet::carrier_track::inline reference_integrators
