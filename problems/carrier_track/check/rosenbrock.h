#pragma once

#include <memory>

#include "problems/carrier_track/check/flight_method.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// Flights by Boost.Odeint's rosenbrock4. Separate from odeint.cpp, because its source
/// must be C++17.
std::unique_ptr<FlightMethod> rosenbrock_flight(const FlightSetting& setting, double tolerance);

/// Boost.Odeint's Rosenbrock method of order 4 straight through contacts, with the exact Jacobian.
/// NOTE: separate from the list of methods, because it must be C++17: see rosenbrock.h.
std::unique_ptr<StepMethod> rosenbrock_steps(const PenaltySystem& system, double tolerance);

}  // namespace ricochet::carrier_track::inline reference_integrators
