#include "problems/carrier_track/check/reference_integrators/rosenbrock_steps.h"

#include <utility>

#include "problems/carrier_track/check/reference_integrators/dense_flight.h"
#include "problems/carrier_track/check/reference_integrators/rosenbrock.h"
#include "problems/carrier_track/check/reference_integrators/take_step.h"

namespace ricochet::carrier_track::inline reference_integrators {
namespace {

using namespace rosenbrock;

class RosenbrockSteps : public StepMethod {
 public:
  RosenbrockSteps(const PenaltySystem& system, double tolerance)
      : system_(system),
        stepper_(tolerance * system.length, tolerance, longest_step(system.forces, system.window)),
        step_(0.1 * longest_step(system.forces, system.window)),
        state_(2) {}

  void step(double& time, State& state) override {
    const auto slope = [this](const Vector& x, Vector& dxdt, double t) {
      ++evaluations_;
      dxdt[0] = x[1];
      dxdt[1] = system_.acceleration(t, {x[0], x[1]});
    };
    const auto jacobian = [this](const Vector& x, Matrix& j, double t, Vector& dfdt) {
      const WallForce::Slopes slopes = system_.wall.slopes({x[0], x[1]});
      j(0, 0) = 0;
      j(0, 1) = 1;
      j(1, 0) = slopes.by_position;
      j(1, 1) = slopes.by_velocity;
      dfdt[0] = 0;
      dfdt[1] = system_.forces.applied_rate(t);
    };
    state_[0] = state.position;
    state_[1] = state.velocity;
    take_step(stepper_, std::make_pair(slope, jacobian), state_, time, step_, system_.window);
    state = {state_[0], state_[1]};
  }

  std::int64_t evaluations() const override { return evaluations_; }

 private:
  const PenaltySystem& system_;
  Controller stepper_;
  double step_;  // [s], proposed by the stepper
  Vector state_;
  std::int64_t evaluations_ = 0;
};

}  // namespace

std::unique_ptr<StepMethod> rosenbrock_steps(const PenaltySystem& system, double tolerance) {
  return std::make_unique<RosenbrockSteps>(system, tolerance);
}

}  // namespace ricochet::carrier_track::inline reference_integrators
