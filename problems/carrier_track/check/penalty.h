#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "problems/carrier_track/check/fixed_step.h"
#include "problems/carrier_track/check/integrator.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// Makes a method for a system, which must outlive it.
using MakeStepMethod =
    std::function<std::unique_ptr<StepMethod>(const PenaltySystem&, double control)>;

/// A penalty method: integrates straight through the contacts and does not locate their ends.
/// - A contact begins at a step that ends behind a wall and is over at one that ends before it. A
///   contact that begins and ends within a step is missed.
/// - With contact_speed "each", the damping of a contact is scaled with the speed at the beginning
///   of the step that enters it, at least resting_speed.
/// - The reported time and speed of an impact are those at which the state before that step, under
///   the force of that moment, reaches the wall: the error of the time is of the order of the step
///   cubed.
/// - A body further behind a wall than the gap is wide ends the run.
Integrator penalty_integrator(std::string name, std::string version, std::string control,
                              MakeStepMethod method);

/// The length of equal steps [s] of a penalty method, none longer than requested. Throws
/// std::runtime_error for more than most_fixed_steps.
double equal_steps(double window, double longest);

/// Equal steps by `rule(system, time, state, length)`, which returns the state after one step and
/// costs `evaluations` accelerations.
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
    // Rounding may leave the last step just before the window's end.
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
