#include "src/research/calibration/variants/ode45.h"

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <stdexcept>

namespace ricochet::studies::variants {
namespace {

constexpr double power = 0.2;  // 1 over the order of the pair

}  // namespace

Ode45::Ode45(Slope slope, const OdeState& start, double window, const OdeTolerances& tolerances)
    : slope_(std::move(slope)),
      window_(window),
      tolerances_(tolerances),
      state_(start),
      rate_(slope_(start, 0)) {
  const double threshold = tolerances.absolute / tolerances.relative;
  double rate = 0;
  for (std::size_t i = 0; i < state_.size(); ++i) {
    rate = std::max(rate, std::abs(rate_[i]) / std::max(std::abs(state_[i]), threshold));
  }
  rate /= 0.8 * std::pow(tolerances.relative, power);
  length_ = longest() * rate > 1 ? 1 / rate : longest();
}

void Ode45::step() {
  const double threshold = tolerances_.absolute / tolerances_.relative;
  boost::numeric::odeint::runge_kutta_dopri5<OdeState> pair;
  const auto system = [this](const OdeState& x, OdeState& dxdt, double t) { dxdt = slope_(x, t); };
  bool failed = false;
  length_ = std::min(length_, longest());
  for (;;) {
    // As in ode45: a step that nearly reaches the end of the window is stretched to it.
    const bool last = 1.1 * length_ >= window_ - time_;
    if (last) length_ = window_ - time_;
    if (!last && !(length_ > 16 * std::abs(std::nextafter(time_, window_) - time_))) {
      throw std::runtime_error("no step is small enough");
    }
    ++steps_;
    OdeState next, next_rate, difference;
    pair.do_step(system, state_, rate_, time_, next, next_rate, length_, difference);
    double error = 0;
    for (std::size_t i = 0; i < next.size(); ++i) {
      const double size = std::max({std::abs(state_[i]), std::abs(next[i]), threshold});
      error = std::max(error, std::abs(difference[i]) / size);
    }
    if (!std::isfinite(error)) throw std::runtime_error("the motion has no bounds");
    if (error > tolerances_.relative) {
      length_ *= failed ? 0.5 : std::max(0.1, 0.8 * std::pow(tolerances_.relative / error, power));
      failed = true;
      continue;
    }
    time_ = last ? window_ : time_ + length_;
    state_ = next;
    rate_ = next_rate;
    if (!failed) {
      length_ /= std::max(0.2, 1.25 * std::pow(error / tolerances_.relative, power));
    }
    return;
  }
}

}  // namespace ricochet::studies::variants
