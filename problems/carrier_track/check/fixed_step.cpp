#include "problems/carrier_track/check/fixed_step.h"

#include <cmath>

#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/check/penalty.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track::inline reference_integrators {

bool plan_steps(const Scene& scene, double longest, StepPlan& plan, Outcome& outcome) {
  const double window = duration_of(scene);
  const double count = std::ceil(window / longest);
  if (!(count <= most_fixed_steps)) {
    outcome.end = {0.0, scene.start_position, scene.start_velocity};
    outcome.failure = "more than 100000000 steps";
    return false;
  }
  plan = {static_cast<std::int64_t>(count), window / count};
  return true;
}

namespace {

/// Classical Runge-Kutta; its two middle stages need one evaluation, since the forces depend only
/// on time. Friction keeps the sign that it has at the start of the step. A body under friction
/// whose velocity has changed sign by the end is at rest there: with the wrong sign it would gain
/// energy.
State runge_kutta_step(const Forces& forces, double time, const State& state, int direction,
                       double length) {
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
            return run_with_reflection(scene, longest, 3, runge_kutta_step);
          }};
}

Integrator penalty_runge_kutta_4() {
  return equal_step_penalty("runge-kutta-4", "ricochet " RICOCHET_VERSION, 4, penalty_step);
}

namespace {

State euler_step(const Forces& forces, double time, const State& state, int /*direction*/,
                 double length) {
  const double pushed = state.velocity + length * forces.applied(time);
  const double velocity = after_friction(pushed, length * forces.friction);
  return {state.position + length * velocity, velocity};
}

}  // namespace

Integrator semi_implicit_euler() {
  return {"semi-implicit-euler", "ricochet " RICOCHET_VERSION, "step [s]",
          [](const Scene& scene, double longest) {
            return run_with_reflection(scene, longest, 1, euler_step);
          }};
}

Integrator penalty_semi_implicit_euler() {
  return equal_step_penalty(
      "semi-implicit-euler", "ricochet " RICOCHET_VERSION, 1,
      [](const PenaltySystem& system, double time, const State& state, double length) {
        const double velocity = state.velocity + length * system.acceleration(time, state);
        return State{state.position + length * velocity, velocity};
      });
}

namespace {

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
class MoreauJean {
 public:
  MoreauJean(const Scene& scene, double length)
      : scene_(scene),
        forces_(forces_of(scene)),
        length_(length),
        state_{scene.start_position, scene.start_velocity},
        push_(forces_.applied(0.0)) {}

  /// Takes one step to `time`; appends to `impacts`.
  void step(double time, std::vector<Impact>& impacts) {
    const double push = forces_.applied(time);
    const double pushed = state_.velocity + 0.5 * length_ * (push_ + push);
    push_ = push;
    double velocity = after_friction(pushed, length_ * forces_.friction);
    const double predicted = state_.position + 0.5 * length_ * state_.velocity;
    const int wall = (predicted >= scene_.wall_upper) - (predicted <= scene_.wall_lower);
    if (wall != 0) velocity = after_contact(wall, velocity, time, impacts);
    state_.position += 0.5 * length_ * (state_.velocity + velocity);
    state_.velocity = velocity;
  }

  const State& state() const { return state_; }

 private:
  double after_contact(int wall, double free, double time, std::vector<Impact>& impacts) const {
    const double approach = wall * state_.velocity;
    const double restitution = wall > 0 ? upper_restitution(scene_) : lower_restitution(scene_);
    double rebound = restitution * approach;
    if (std::abs(rebound) <= slowest_rebound) rebound = 0;
    if (wall * free <= -rebound) return free;  // no impulse
    if (approach > 0) impacts.push_back({time, wall > 0 ? Wall::upper : Wall::lower, approach});
    return -wall * rebound;
  }

  const Scene& scene_;
  Forces forces_;
  double length_;  // [s]
  State state_;
  double push_;  // [m/s^2], applied at the start of the step
};

Outcome run_moreau_jean(const Scene& scene, double longest) {
  Outcome outcome;
  StepPlan plan{};
  if (!plan_steps(scene, longest, plan, outcome)) return outcome;
  MoreauJean method(scene, plan.length);
  double time = 0;
  std::int64_t done = 0;
  while (done < plan.count && outcome.impacts.size() < most_impacts) {
    time = static_cast<double>(++done) * plan.length;
    method.step(time, outcome.impacts);
  }
  outcome.force_evaluations = 1 + done;
  outcome.end = {time, method.state().position, method.state().velocity};
  outcome.finished = done == plan.count;
  if (!outcome.finished) outcome.failure = "more than 1000000 impacts";
  return outcome;
}

}  // namespace

Integrator moreau_jean() {
  return {"moreau-jean", "ricochet " RICOCHET_VERSION, "step [s]", run_moreau_jean};
}

}  // namespace ricochet::carrier_track::inline reference_integrators
