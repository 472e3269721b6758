#include "problems/carrier_track/check/rosenbrock.h"

#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_controller.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_dense_output.hpp>
#include <utility>

#include "problems/carrier_track/check/flight_method.h"

/// Boost.Odeint's rosenbrock4 with a corrected coefficient. NOTE: plain C++17; it does not compile
/// as C++20.
namespace ricochet::carrier_track::rosenbrock {

namespace odeint = boost::numeric::odeint;

// NOTE: up to Boost 1.74 at least, d4 of the method (Hairer and Wanner's RODAS) has the wrong sign,
// which leaves order 2 if the forces depend on time. This member hides it.
struct Coefficients : odeint::default_rosenbrock_coefficients<double> {
  const double d4 = -0.3620000000000023e-01;
};

using Method = odeint::rosenbrock4<double, Coefficients>;
using Vector = Method::state_type;
using Matrix = Method::matrix_type;
using Controller = odeint::rosenbrock4_controller<Method>;

}  // namespace ricochet::carrier_track::rosenbrock

namespace ricochet::carrier_track::inline reference_integrators {

namespace {

using namespace rosenbrock;

class RosenbrockFlight : public FlightMethod {
 public:
  RosenbrockFlight(const FlightSetting& setting, double tolerance)
      : setting_(setting),
        stepper_(Controller(tolerance * setting.length, tolerance,
                            longest_step(setting.forces, setting.window))),
        step_(0.1 * longest_step(setting.forces, setting.window)),
        longest_(step_),
        workspace_(2) {}

  Landing fly(const Leg& leg) override {
    const double friction = leg.direction * setting_.forces.friction;
    const auto pull = [&](double time) {
      ++evaluations_;
      return setting_.forces.applied(leg.start + time) - friction;
    };
    const auto slope = [&](const Vector& x, Vector& dxdt, double time) {
      dxdt[0] = x[1];
      dxdt[1] = pull(time);
    };
    const auto jacobian = [&](const Vector& /*x*/, Matrix& j, double time, Vector& dfdt) {
      j(0, 0) = 0;
      j(0, 1) = 1;
      j(1, 0) = 0;
      j(1, 1) = 0;
      dfdt[0] = 0;
      dfdt[1] = setting_.forces.applied_rate(leg.start + time);
    };
    // NOTE: the dense output is only as good as the tolerance, and a rebound much shorter than the
    // step is lost in it: without this limit a Zeno sequence goes on forever as noise.
    step_ = std::min(step_, longest_);
    const Landing landing = fly_dense(stepper_, std::make_pair(slope, jacobian), pull, setting_.gap,
                                      setting_.forces.friction > 0, leg, workspace_, step_, steps_);
    if (landing.duration > 0) longest_ = 2 * landing.duration;
    return landing;
  }

  std::int64_t evaluations() const override { return evaluations_; }

 private:
  FlightSetting setting_;
  boost::numeric::odeint::rosenbrock4_dense_output<Controller> stepper_;
  double step_;     // [s], proposed by the stepper
  double longest_;  // [s], the first step of the next leg
  Vector workspace_;
  std::int64_t steps_ = 0;
  std::int64_t evaluations_ = 0;
};

}  // namespace

std::unique_ptr<FlightMethod> rosenbrock_flight(const FlightSetting& setting, double tolerance) {
  return std::make_unique<RosenbrockFlight>(setting, tolerance);
}

namespace {

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
