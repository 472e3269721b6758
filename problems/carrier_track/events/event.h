#pragma once

#include <cstdint>

#include "problems/carrier_track/flight/flight.h"

namespace ricochet::carrier_track::inline events {

/// +1 up, -1 down, 0 at rest.
inline int direction_of(double velocity) {
  return (velocity > 0) - (velocity < 0);
}

enum class EventKind {
  wall,     ///< the wall ahead is reached
  turn,     ///< the velocity reaches zero
  release,  ///< a resting body starts to move
  horizon   ///< nothing happens before the time limit
};

struct Event {
  EventKind kind;
  double time;    ///< [s] from the start of the path
  int direction;  ///< release: +1 up, -1 down; else the direction of motion
};

/// First event of a body that moves in `direction` (+1 or -1) with the wall `ahead` [m] >= 0 of it,
/// within `horizon` [s]. The search advances only as far as a bound proves that the velocity keeps
/// its sign; there the position is monotone, so that no wall is skipped, however short the contact.
/// The path is advanced to the event. `evaluations` grows by its evaluations.
///
/// For Path = Flight<double> and RampFlight<double>.
template <class Path>
Event next_event(Path& path, int direction, double ahead, double horizon,
                 std::int64_t& evaluations);

}  // namespace ricochet::carrier_track::inline events
