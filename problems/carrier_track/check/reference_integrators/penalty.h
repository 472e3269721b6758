#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "problems/carrier_track/reference_integrators/integrator.h"
#include "problems/carrier_track/reference_integrators/step_method.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// Makes a method for a system that outlives it.
using MakeStepMethod =
    std::function<std::unique_ptr<StepMethod>(const PenaltySystem&, double control)>;

/// A penalty method: integrates straight through the contacts, whose edges it does not locate.
/// - A contact is seen where a step ends behind a wall, and over where one ends before it. One that
///   begins and ends within a step is never seen.
/// - With contact_speed "each", the damping of a contact is scaled with the speed at the beginning
///   of the step that enters it, at least resting_speed.
/// - The time and the speed told of an impact are those at which the state before that step, under
///   the force of that moment, reaches the wall: wrong by the cube of the step for the time.
/// - A body further behind a wall than the gap is wide has left the scene: the run ends there.
Integrator penalty_integrator(std::string name, std::string version, std::string control,
                              MakeStepMethod method);

/// The length of equal steps for a penalty method that takes such [s], none longer than asked for.
/// Throws std::runtime_error for more than most_fixed_steps.
double equal_steps(double window, double longest);

/// Equal steps by `rule(system, time, state, length)`, which returns the state after one and costs
/// `evaluations` accelerations.
template <class Rule>
class EqualSteps : public StepMethod {
 public:
  EqualSteps(const PenaltySystem& system, double longest, std::int64_t evaluations, Rule rule)
      : system_(system),
        length_(equal_steps(system.window, longest)),
        evaluations_(evaluations),
        rule_(rule) {}

  void step(double& time, State& state) override {
    state = rule_(system_, time, state, length_);
    time = static_cast<double>(++steps_) * length_;
    // The last step ends where rounding may leave it just before the window's end.
    if (system_.window - time < 0.5 * length_) time = system_.window;
  }

  std::int64_t evaluations() const override { return steps_ * evaluations_; }

 private:
  const PenaltySystem& system_;
  double length_;  // [s]
  std::int64_t evaluations_;
  Rule rule_;
  std::int64_t steps_ = 0;
};

template <class Rule>
Integrator equal_step_penalty(std::string name, std::string version, std::int64_t evaluations,
                              Rule rule) {
  return penalty_integrator(std::move(name), std::move(version), "step [s]",
                            [evaluations, rule](const PenaltySystem& system, double longest) {
                              return std::make_unique<EqualSteps<Rule>>(system, longest,
                                                                        evaluations, rule);
                            });
}

}  // namespace ricochet::carrier_track::inline reference_integrators
