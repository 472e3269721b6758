#pragma once

#include <cstdint>

#include "problems/carrier_track/events/event.h"

namespace ricochet::carrier_track::inline events {

/// First time within `horizon` [s] at which the applied acceleration of a resting body (the path's,
/// without friction) leaves the band [-friction, friction] [m/s^2] in an allowed direction: an
/// Event release, or horizon with direction 0. `evaluations` grows by the evaluations of the path.
///
/// For Path = Flight<double> and RampFlight<double>.
template <class Path>
Event next_release(const Path& applied, double friction, bool may_rise, bool may_fall,
                   double horizon, std::int64_t& evaluations);

}  // namespace ricochet::carrier_track::inline events
