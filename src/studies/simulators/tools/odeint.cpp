// Boost.Odeint: Dormand-Prince 5(4) with dense output; a sign change is bisected, as its manual's
// section on event location does.
#include <boost/numeric/odeint.hpp>

#include "motion.h"

using namespace impact_test;
namespace odeint = boost::numeric::odeint;

using State = Motion::State;

/// Bisects value k, which is negative at the end of the stepper's last step.
template <typename Stepper>
static double root(const Motion& motion, Stepper& stepper, int k) {
  auto [a, b] = std::pair(stepper.previous_time(), stepper.current_time());
  State y;
  for (double middle = (a + b) / 2; middle > a && middle < b; middle = (a + b) / 2) {
    stepper.calc_state(middle, y);
    (motion.values(middle, y.data())[k] < 0 ? b : a) = middle;
  }
  return b;
}

static Result simulate(const Scene& scene, const Call& call) {
  const double tolerance = call.pick(1e-4, 1e-6, 1e-12);
  Motion motion(scene, tolerance);
  const auto rates = [&](const State& y, State& dy, double t) {
    motion.rates(t, y.data(), dy.data());
  };
  while (!motion.over()) {
    auto stepper =
        odeint::make_dense_output(tolerance * scene.length(), tolerance, motion.longest_step(),
                                  odeint::runge_kutta_dopri5<State>());
    stepper.initialize(motion.state, motion.time, motion.first_step());
    const double end = motion.end();
    int event = -1;
    double first = motion.time;
    State y;
    while (event < 0 && first < end) {
      stepper.do_step(rates);
      first = std::min(stepper.current_time(), end);
      stepper.calc_state(first, y);
      const auto values = motion.values(first, y.data());
      for (int k = 0; k < Motion::values_count; ++k) {
        const double t = values[k] < 0 ? root(motion, stepper, k) : infinity;
        if (t <= first) std::tie(first, event) = std::pair(t, k);
      }
    }
    stepper.calc_state(first, y);
    motion.proceed(first, y.data(), event);
  }
  return motion.result;
}

int main(int argc, char** argv) {
  return run(argc, argv, simulate);
}
