#include <array>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/version.hpp>

#include "problems/carrier_track/check/fixed_step.h"
#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/check/penalty.h"
#include "problems/carrier_track/check/rosenbrock.h"

namespace ricochet::carrier_track::inline reference_integrators {

namespace {

namespace odeint = boost::numeric::odeint;

// NOTE: an array, not a std::vector: no allocation in a step, and the compiler unrolls it.
using Vector = std::array<double, 2>;

class Dopri5 : public FlightMethod {
 public:
  Dopri5(const FlightSetting& setting, double tolerance)
      : setting_(setting),
        stepper_(odeint::make_dense_output(tolerance * setting.length, tolerance,
                                           longest_step(setting.forces, setting.window),
                                           odeint::runge_kutta_dopri5<Vector>())),
        step_(0.1 * longest_step(setting.forces, setting.window)) {}

  Landing fly(const Leg& leg) override {
    const double friction = leg.direction * setting_.forces.friction;
    const auto pull = [&](double time) {
      ++evaluations_;
      return setting_.forces.applied(leg.start + time) - friction;
    };
    const auto system = [&](const Vector& x, Vector& slope, double time) {
      slope = {x[1], pull(time)};
    };
    return fly_dense(stepper_, system, pull, setting_.gap, setting_.forces.friction > 0, leg,
                     workspace_, step_, steps_);
  }

  std::int64_t evaluations() const override { return evaluations_; }

 private:
  FlightSetting setting_;
  odeint::result_of::make_dense_output<odeint::runge_kutta_dopri5<Vector>>::type stepper_;
  Vector workspace_{};
  double step_;
  std::int64_t steps_ = 0;
  std::int64_t evaluations_ = 0;
};

class Dopri5Steps : public StepMethod {
 public:
  Dopri5Steps(const PenaltySystem& system, double tolerance)
      : system_(system),
        stepper_(odeint::make_controlled(tolerance * system.length, tolerance,
                                         longest_step(system.forces, system.window),
                                         odeint::runge_kutta_dopri5<Vector>())),
        step_(0.1 * longest_step(system.forces, system.window)) {}

  void step(double& time, State& state) override {
    const auto slope = [this](const Vector& x, Vector& dxdt, double t) {
      ++evaluations_;
      dxdt = {x[1], system_.acceleration(t, {x[0], x[1]})};
    };
    Vector x = {state.position, state.velocity};
    // NOTE: the stepper reuses the last slope as the first of the next step. It is the same one,
    // except for the damping's scale, which acts only inside the walls.
    take_step(stepper_, slope, x, time, step_, system_.window);
    state = {x[0], x[1]};
  }

  std::int64_t evaluations() const override { return evaluations_; }

 private:
  const PenaltySystem& system_;
  odeint::result_of::make_controlled<odeint::runge_kutta_dopri5<Vector>>::type stepper_;
  double step_;  // [s], proposed by the stepper
  std::int64_t evaluations_ = 0;
};

}  // namespace

Integrator odeint_dopri5() {
  return {"odeint-dopri5", "Boost " BOOST_LIB_VERSION, "relative tolerance",
          [](const Scene& scene, double tolerance) {
            Dopri5 method(flight_setting(scene), tolerance);
            return run_with_located_events(scene, method);
          }};
}

Integrator penalty_odeint_dopri5() {
  return penalty_integrator("odeint-dopri5", "Boost " BOOST_LIB_VERSION, "relative tolerance",
                            [](const PenaltySystem& system, double tolerance) {
                              return std::make_unique<Dopri5Steps>(system, tolerance);
                            });
}

Integrator odeint_rosenbrock4() {
  return {"odeint-rosenbrock4", "Boost " BOOST_LIB_VERSION, "relative tolerance",
          [](const Scene& scene, double tolerance) {
            const auto method = rosenbrock_flight(flight_setting(scene), tolerance);
            return run_with_located_events(scene, *method);
          }};
}

Integrator penalty_odeint_rosenbrock4() {
  return penalty_integrator("odeint-rosenbrock4", "Boost " BOOST_LIB_VERSION, "relative tolerance",
                            rosenbrock_steps);
}

}  // namespace ricochet::carrier_track::inline reference_integrators
