#pragma once

#include "problems/carrier_track/reference_integrators/flight_method.h"
#include "problems/carrier_track/reference_integrators/integrator.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// Simulates a valid scene with the flights of `method`, made for the same scene. The discrete part
/// of the motion is alike for all such methods:
/// - Impact: the velocity is reversed, times the restitution, and the method restarted.
/// - Rest: on a wall, unless the force leads away, once the rebound is at most slowest_rebound or
///   its hop is lost in the rounding of the position; in the gap where the body turns and is held.
/// - Departure: where the applied force exceeds what friction and wall hold, by a sign change
///   between samples 1/64 of the shortest period apart, located to rounding. A force that exceeds
///   it for less than that is missed.
Outcome run_with_located_events(const Scene& scene, FlightMethod& method);

}  // namespace ricochet::carrier_track::inline reference_integrators
