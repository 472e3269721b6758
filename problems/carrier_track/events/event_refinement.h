#pragma once

#include "problems/carrier_track/events/event.h"
#include "ricochet/scalar.h"

namespace ricochet::carrier_track::inline events {

/// Advances a path to an event that the search has found in plain arithmetic, and returns the
/// event's exact time [s]: the path is at `wall` [m], its velocity is zero, or the `horizon` [s] is
/// reached. The event of a dual is that of its inner numbers; its derivatives follow from those of
/// the path there, by the implicit function theorem.
template <class Path, class Scalar>
Scalar refine_event(Path& path, const Event& event, const Scalar& wall, const Scalar& horizon) {
  if constexpr (Dual<Scalar>) {
    auto inner = path.inner();
    Scalar time(refine_event(inner, event, wall.a, horizon.a));
    path.advance(time);
    // Touching a wall with zero velocity has no derivative; its time is taken as constant.
    if (event.kind == EventKind::wall && value(path.velocity) != 0) {
      time.v = (wall.v - path.position.v) / path.velocity.a;
    } else if (event.kind == EventKind::turn && value(path.inner_acceleration()) != 0) {
      time.v = -path.velocity.v / path.inner_acceleration();
    } else if (event.kind == EventKind::horizon) {
      time.v = horizon.v;
    }
    path.shift_time_derivative(time.v);
    return time;
  } else {
    Scalar time = event.kind == EventKind::horizon ? horizon : static_cast<Scalar>(event.time);
    if (newton_steps < Scalar >> 0) path.advance(time);
    for (int i = 0; i < newton_steps<Scalar>; ++i) {
      Scalar late = 0;
      if (event.kind == EventKind::wall && path.velocity != 0) {
        late = (wall - path.position) / path.velocity;
      } else if (event.kind == EventKind::turn && path.acceleration() != 0) {
        late = -path.velocity / path.acceleration();
      }
      path.advance(late);
      time += late;
    }
    return time;
  }
}

}  // namespace ricochet::carrier_track::inline events
