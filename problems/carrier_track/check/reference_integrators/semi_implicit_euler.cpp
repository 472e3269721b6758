#include "problems/carrier_track/check/reference_integrators/fixed_step.h"
#include "problems/carrier_track/check/reference_integrators/methods.h"
#include "problems/carrier_track/check/reference_integrators/penalty.h"

namespace ricochet::carrier_track::inline reference_integrators {
namespace {

State step(const Forces& forces, double time, const State& state, int /*direction*/,
           double length) {
  const double pushed = state.velocity + length * forces.applied(time);
  const double velocity = after_friction(pushed, length * forces.friction);
  return {state.position + length * velocity, velocity};
}

}  // namespace

Integrator semi_implicit_euler() {
  return {"semi-implicit-euler", "ricochet " RICOCHET_VERSION, "step [s]",
          [](const Scene& scene, double longest) {
            return run_with_reflection(scene, longest, 1, step);
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

}  // namespace ricochet::carrier_track::inline reference_integrators
