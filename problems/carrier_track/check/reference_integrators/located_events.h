#pragma once

#include "problems/carrier_track/check/reference_integrators/flight_method.h"
#include "problems/carrier_track/check/reference_integrators/integrator.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// Simulates a valid scene with the flights of `method`, made for the same scene. The discrete part
/// of the motion is the same for all such methods:
/// - Impact: the velocity is reversed and multiplied by the restitution, and the method restarted.
/// - Rest: on a wall, unless the force leads away, once the rebound is at most slowest_rebound or
///   its height is lost in the rounding of the position; in the gap if the velocity is zero and
///   friction holds the body.
/// - Departure: when the applied force exceeds what friction and wall hold, detected by a sign
///   change between samples 1/64 of the shortest period apart and located to rounding. An excess
///   that lasts less than that is missed.
Outcome run_with_located_events(const Scene& scene, FlightMethod& method);

}  // namespace ricochet::carrier_track::inline reference_integrators
