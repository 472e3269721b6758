#include <algorithm>
#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_controller.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_dense_output.hpp>
#include <utility>

#include "problems/carrier_track/check/method.h"

/// Boost.Odeint's rosenbrock4 with a corrected coefficient. NOTE: plain C++17; it does not compile
/// as C++20.
namespace ricochet::carrier_track::inline reference_integrators {

namespace {

namespace odeint = boost::numeric::odeint;

// NOTE: up to Boost 1.74 at least, d4 of the method (Hairer and Wanner's RODAS) has the wrong sign,
// which leaves order 2 if the forces depend on time. This member hides it.
struct Coefficients : odeint::default_rosenbrock_coefficients<double> {
  const double d4 = -0.3620000000000023e-01;
};

using Stepper = odeint::rosenbrock4<double, Coefficients>;
using Vector = Stepper::state_type;
using Matrix = Stepper::matrix_type;
using Controller = odeint::rosenbrock4_controller<Stepper>;

class Rosenbrock : public Method {
 public:
  Rosenbrock(System& system, double tolerance)
      : Method(system),
        stepper_(Controller(tolerance * system.length, tolerance, system.longest_step())),
        step_(0.1 * system.longest_step()) {}

  void start(const State& state) override {
    // NOTE: the dense output is only as good as the tolerance, and a rebound much shorter than the
    // step is lost in it: without this limit a Zeno sequence goes on forever as noise.
    if (last_flight_ > 0) step_ = std::min(step_, 2 * last_flight_);
    x_[0] = state.position;
    x_[1] = state.velocity;
    stepper_.initialize(x_, 0.0, step_);
  }

  double step() override {
    const auto slope = [this](const Vector& x, Vector& dxdt, double t) {
      dxdt[0] = x[1];
      dxdt[1] = system_.acceleration(t, {x[0], x[1]});
    };
    const auto jacobian = [this](const Vector& x, Matrix& j, double t, Vector& dfdt) {
      const WallForce::Slopes slopes = system_.slopes({x[0], x[1]});
      j(0, 0) = 0;
      j(0, 1) = 1;
      j(1, 0) = slopes.by_position;
      j(1, 1) = slopes.by_velocity;
      dfdt[0] = 0;
      dfdt[1] = system_.applied_rate(t);
    };
    stepper_.do_step(std::make_pair(slope, jacobian));
    step_ = stepper_.current_time_step();
    return stepper_.current_time();
  }

  State at(double time) override {
    if (time == stepper_.current_time()) {
      return {stepper_.current_state()[0], stepper_.current_state()[1]};
    }
    stepper_.calc_state(time, x_);
    return {x_[0], x_[1]};
  }

 private:
  odeint::rosenbrock4_dense_output<Controller> stepper_;
  double step_;  // [s], proposed by the stepper
  Vector x_{2};
};

}  // namespace

std::unique_ptr<Method> rosenbrock(System& system, double tolerance) {
  return std::make_unique<Rosenbrock>(system, tolerance);
}

}  // namespace ricochet::carrier_track::inline reference_integrators
