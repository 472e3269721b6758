#include <cmath>

#include "problems/carrier_track/check/reference_integrators/fixed_step.h"
#include "problems/carrier_track/check/reference_integrators/methods.h"
#include "problems/carrier_track/scene/contact_restitution.h"
#include "ricochet/recording.h"

namespace ricochet::carrier_track::inline reference_integrators {
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

Outcome run(const Scene& scene, double longest) {
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
  return {"moreau-jean", "ricochet " RICOCHET_VERSION, "step [s]", run};
}

}  // namespace ricochet::carrier_track::inline reference_integrators
