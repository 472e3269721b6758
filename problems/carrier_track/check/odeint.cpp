#include <array>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/version.hpp>

#include "problems/carrier_track/check/walls.h"

namespace ricochet::carrier_track::inline reference_integrators {

namespace {

namespace odeint = boost::numeric::odeint;

// NOTE: an array, not a std::vector: no allocation in a step, and the compiler unrolls it.
using Vector = std::array<double, 2>;

class Dopri5 : public Method {
 public:
  Dopri5(System& system, double tolerance)
      : Method(system),
        stepper_(odeint::make_dense_output(tolerance * system.length, tolerance,
                                           system.longest_step(),
                                           odeint::runge_kutta_dopri5<Vector>())),
        step_(0.1 * system.longest_step()) {}

  void start(const State& state) override {
    stepper_.initialize(Vector{state.position, state.velocity}, 0.0, step_);
  }

  double step() override {
    // NOTE: the stepper reuses the last slope as the first of the next step. It is the same one,
    // except for the scale of a compliant wall's damping, which acts only inside the walls.
    stepper_.do_step([this](const Vector& x, Vector& slope, double time) {
      slope = {x[1], system_.acceleration(time, {x[0], x[1]})};
    });
    step_ = stepper_.current_time_step();
    return stepper_.current_time();
  }

  State at(double time) override {
    Vector x = stepper_.current_state();
    if (time != stepper_.current_time()) stepper_.calc_state(time, x);
    return {x[0], x[1]};
  }

 private:
  odeint::result_of::make_dense_output<odeint::runge_kutta_dopri5<Vector>>::type stepper_;
  double step_;  // [s], proposed by the stepper
};

std::unique_ptr<Method> dopri5(System& system, double tolerance) {
  return std::make_unique<Dopri5>(system, tolerance);
}

}  // namespace

Integrator odeint_dopri5() {
  return adaptive("odeint-dopri5", "Boost " BOOST_LIB_VERSION,
                  "Boost.Odeint, Dormand-Prince 5(4) with dense output", dopri5);
}

Integrator odeint_rosenbrock4() {
  return adaptive("odeint-rosenbrock4", "Boost " BOOST_LIB_VERSION,
                  "Boost.Odeint, Rosenbrock of order 4 with dense output", rosenbrock);
}

Integrator penalty() {
  return with_springs("penalty", "Boost " BOOST_LIB_VERSION,
                      "A spring and a damper for each wall, by Boost.Odeint's Rosenbrock",
                      rosenbrock);
}

}  // namespace ricochet::carrier_track::inline reference_integrators
