#pragma once

#include <memory>

#include "problems/carrier_track/check/reference_integrators/flight_method.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// Flights by Boost.Odeint's rosenbrock4. Separate from odeint_rosenbrock4.cpp, because its source
/// must be C++17.
std::unique_ptr<FlightMethod> rosenbrock_flight(const FlightSetting& setting, double tolerance);

}  // namespace ricochet::carrier_track::inline reference_integrators
