#pragma once

#include <memory>

#include "problems/carrier_track/check/reference_integrators/step_method.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// Boost.Odeint's Rosenbrock method of order 4 straight through contacts, with the exact Jacobian.
/// NOTE: separate from the list of methods, because it must be C++17: see rosenbrock.h.
std::unique_ptr<StepMethod> rosenbrock_steps(const PenaltySystem& system, double tolerance);

}  // namespace ricochet::carrier_track::inline reference_integrators
