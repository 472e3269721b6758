// A penalty method of ours: walls are springs and dampers, integrated by Boost.Odeint's controlled
// Dormand-Prince 5(4). The level sets how deep the fastest body gets. A wall pulls while a body
// leaves it, so that the ratio of the speeds is exp(-pi z / sqrt(1 - z^2)), z the damping ratio.
#include <boost/numeric/odeint.hpp>

#include "tool.h"

using namespace impact_test;
namespace odeint = boost::numeric::odeint;

using State = std::array<double, 2>;

static double damping_ratio(double restitution) {
  if (restitution <= 0) return 1;
  const double logarithm = std::log(restitution);
  return -logarithm / std::hypot(M_PI, logarithm);
}

static Result simulate(const Scene& scene, const Call& call) {
  const double depth = scene.length() * call.pick(1e-2, 1e-3, 1e-4);
  const double frequency = scene.speed() / depth;  // of the body on a wall [rad/s]
  const double creep = scene.speed() * call.pick(1e-2, 1e-3, 1e-4);
  const double lower = 2 * damping_ratio(scene.restitution_lower) * frequency;
  const double upper = 2 * damping_ratio(scene.restitution_upper) * frequency;
  const auto rates = [&](const State& y, State& dy, double t) {
    const double in = std::clamp(y[0], scene.lower, scene.upper) - y[0];
    const double friction = scene.friction * std::tanh(y[1] / creep);
    dy[0] = y[1];
    dy[1] = (scene.force(t) - friction) / scene.mass + frequency * frequency * in;
    if (in != 0) dy[1] -= (in > 0 ? lower : upper) * y[1];
  };
  const auto gap = [&](const State& y, bool on_upper) {
    return on_upper ? scene.upper - y[0] : y[0] - scene.lower;
  };
  const double tolerance = call.pick(1e-4, 1e-6, 1e-8);
  auto stepper = odeint::make_controlled(tolerance * depth, tolerance, scene.longest_step(),
                                         odeint::runge_kutta_dopri5<State>());
  State y = {scene.position, scene.velocity};
  Result result;
  for (double t = 0, step = scene.longest_step() / 100; t < scene.duration;) {
    const State before = y;
    const double from = t;
    step = std::min(step, scene.duration - t);
    while (stepper.try_step(rates, y, t, step) == odeint::fail) continue;
    for (const bool on_upper : {false, true}) {
      const double was = gap(before, on_upper), now = gap(y, on_upper);
      result.deepest = std::max(result.deepest, -now);
      if (was < 0 || now >= 0) continue;
      const double share = was / (was - now);
      const double speed = before[1] + share * (y[1] - before[1]);
      result.impacts.push_back({from + share * (t - from), on_upper, std::abs(speed)});
    }
  }
  result.end = y;
  return result;
}

int main(int argc, char** argv) {
  return run(argc, argv, simulate);
}
