#pragma once

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_step_result.hpp>
#include <stdexcept>

// NOTE: plain C++17, like forces.h.
namespace ricochet::carrier_track::inline reference_integrators {

/// Takes one accepted step of a controlled stepper of Boost.Odeint, from `time` to at most `end`
/// [s]. `step` [s] is its last proposal. Throws std::runtime_error if no step is small enough.
template <class Stepper, class System, class Vector>
void take_step(Stepper& stepper, const System& system, Vector& state, double& time, double& step,
               double end) {
  double tried = std::min(step, end - time);
  while (stepper.try_step(system, state, time, tried) == boost::numeric::odeint::fail) {
    if (!(time + tried > time)) throw std::runtime_error("no step is small enough");
  }
  step = tried;
}

}  // namespace ricochet::carrier_track::inline reference_integrators
