#pragma once

#include <cstdint>

#include "problems/carrier_track/flight.h"

namespace ricochet::carrier_track {

enum class EventKind {
  wall,    ///< the wall ahead is reached
  turn,    ///< the velocity has come down to zero
  depart,  ///< a resting body starts to move
  horizon  ///< nothing happens before the time limit
};

struct Event {
  EventKind kind;
  double time;    ///< [s] from the start of the flight
  int direction;  ///< depart: +1 up, -1 down; else the direction of motion
};

/// First event of a body that moves in `direction` (+1 or -1) with the wall `ahead` [m] >= 0 of it,
/// within `horizon` [s]. The search advances only as far as the bound on the jerk proves that the
/// velocity keeps its sign; on such a stretch the position is monotone, so that a wall cannot be
/// skipped, however short the contact. `evaluations` grows by the evaluations of the flight.
Event next_event(const Flight<double>& flight, int direction, double ahead, double horizon,
                 std::int64_t& evaluations);

/// First time within `horizon` [s] at which the applied acceleration of a resting body (the
/// flight's, without friction) leaves the band [-friction, friction] [m/s^2] in an allowed
/// direction.
Event next_departure(const Flight<double>& applied, double friction, bool may_rise, bool may_fall,
                     double horizon, std::int64_t& evaluations);

}  // namespace ricochet::carrier_track
