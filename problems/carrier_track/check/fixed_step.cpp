#include <algorithm>
#include <cmath>

#include "problems/carrier_track/check/walls.h"
#include "problems/carrier_track/scene/contact_law.h"

namespace ricochet::carrier_track::inline reference_integrators {

namespace {

/// Classical Runge-Kutta; its two middle stages need one evaluation of the applied forces, which
/// depend only on time. Friction keeps the sign that it has at the start of the step. A body under
/// friction whose velocity has changed sign by the end is at rest there: with the wrong sign it
/// would gain energy. Behind a hard wall the body has the velocity with which it reached the wall:
/// what the force adds beyond, half a step's on average, would feed its rebounds for ever.
State runge_kutta_step(const System& system, double time, const State& state, double length) {
  const double half = 0.5 * length;
  const double friction = system.direction * system.friction;
  const double push = system.applied(time + half) - friction;
  const auto middle = [&](const State& s) { return system.wall ? push + (*system.wall)(s) : push; };
  const double v1 = state.velocity;
  const double a1 = system.acceleration(time, state);
  const double v2 = v1 + half * a1;
  const double a2 = middle({state.position + half * v1, v2});
  const double v3 = v1 + half * a2;
  const double a3 = middle({state.position + half * v2, v3});
  const double v4 = v1 + length * a3;
  const double a4 = system.acceleration(time + length, {state.position + length * v3, v4});
  State next{state.position + length / 6 * (v1 + 2 * v2 + 2 * v3 + v4),
             v1 + length / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
  if (system.friction > 0 && system.direction * next.velocity < 0) next.velocity = 0;
  const int behind = (next.position > system.upper) - (next.position < system.lower);
  if (behind != 0 && !system.wall && behind * next.velocity > 0) {
    const double depth = behind > 0 ? next.position - system.upper : system.lower - next.position;
    const double press = behind * system.acceleration(time + length, next);
    const double square = next.velocity * next.velocity - 2 * press * depth;
    next.velocity = behind * std::sqrt(std::max(square, 0.0));
  }
  return next;
}

State euler_step(const System& system, double time, const State& state, double length) {
  const double pushed = state.velocity + length * system.pushed(time, state);
  const double velocity = after_friction(pushed, length * system.friction);
  return {state.position + length * velocity, velocity};
}

/// Moreau-Jean's scheme with theta = 1/2. Over a step from velocity v to u, with impulses p per
/// mass of the touched wall (normal n, into the gap) and q of friction:
///   u = v + h (a(t) + a(t + h)) / 2 + n p + q
///   0 <= n (u + restitution v)  complementary to  p >= 0, where the predicted position
///   x + h v / 2 is not inside the gap, else p = 0
///   q in -h friction Sign(u)
///   x' = x + h (v + u) / 2.
/// Friction acts along the gap, as the contact does, so both are solved in closed form: first u as
/// if there were no wall, then the larger of that and -restitution v. Rest on a wall and in the gap
/// need no separate case, and Zeno sequences of e < 1 pass through; only the geometric tail of
/// their rebounds is cut, at slowest_rebound. The time of an impact is the end of its step.
Outcome run_moreau_jean(const Scene& scene, double longest) {
  if (scene.fidelity == Fidelity::compliant) throw std::runtime_error("the walls must be hard");
  const System system(scene);
  const auto [count, h] = equal_steps(system.window, longest);
  Outcome outcome;
  State state{scene.start_position, scene.start_velocity};
  outcome.end = {0, state.position, state.velocity};
  double push = system.forces.applied(0);
  for (std::int64_t i = 1; i <= count && outcome.failure.empty(); ++i) {
    const double time = static_cast<double>(i) * h;
    const double next_push = system.forces.applied(time);
    const double pushed = state.velocity + 0.5 * h * (push + next_push);
    push = next_push;
    double velocity = after_friction(pushed, h * system.friction);
    const double predicted = state.position + 0.5 * h * state.velocity;
    const int wall = (predicted >= system.upper) - (predicted <= system.lower);
    const double approach = wall * state.velocity;
    double rebound = approach * (wall > 0 ? upper_restitution(scene) : lower_restitution(scene));
    if (std::abs(rebound) <= slowest_rebound) rebound = 0;
    if (wall != 0 && wall * velocity > -rebound) {  // there is an impulse
      velocity = -wall * rebound;
      try {
        if (approach > 0) add_impact(outcome, time, wall > 0 ? Wall::upper : Wall::lower, approach);
      } catch (const std::runtime_error& error) {
        outcome.failure = error.what();
      }
    }
    state = {state.position + 0.5 * h * (state.velocity + velocity), velocity};
    outcome.end = {time, state.position, state.velocity};
  }
  outcome.force_evaluations = system.forces.evaluations();
  return outcome;
}

}  // namespace

Integrator runge_kutta_4() {
  return stepped("runge-kutta-4", "Runge-Kutta of order 4, fixed steps", runge_kutta_step);
}

Integrator semi_implicit_euler() {
  return stepped("semi-implicit-euler", "Semi-implicit Euler, fixed steps", euler_step);
}

Integrator moreau_jean() {
  return measured({"moreau-jean",
                   "ricochet " RICOCHET_VERSION,
                   "Moreau-Jean, fixed steps",
                   "time stepping",
                   by_step,
                   {1.0 / 240, 1e-3, 1e-4},
                   false,
                   run_moreau_jean});
}

}  // namespace ricochet::carrier_track::inline reference_integrators
