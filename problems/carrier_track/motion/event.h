#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "problems/carrier_track/motion/flight.h"
#include "ricochet/scene.h"

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

/// Reports every local maximum of x to an observer, when the body starts to move down from it. A
/// plateau counts once, at its start.
template <class Scalar>
class PeakWatch {
 public:
  /// The body starts or continues to move in `direction`, -1 or +1.
  template <class SomeObserver>
  void moves(int direction, SomeObserver& observer) {
    if (direction < 0 && summit_) observer.peak(summit_->time, summit_->position);
    summit_.reset();
    rising_ = direction > 0;
  }

  /// The body has stopped or reversed at `time` [s] and `position` [m].
  void stops(const Scalar& time, const Scalar& position) {
    if (rising_ && !summit_) summit_ = Summit{time, position};
  }

 private:
  struct Summit {
    Scalar time, position;
  };

  bool rising_ = false;
  std::optional<Summit> summit_;
};

/// The total time [s] of the infinitely many rebounds of a body that leaves a wall with `speed` > 0
/// [m/s] and is pressed to it with `press` > `friction` [m/s^2], both constant. The body
/// decelerates with press + friction and returns with press - friction: the times form a geometric
/// series.
template <class Scalar>
Scalar zeno_tail(const Scalar& speed, const Scalar& restitution, const Scalar& press,
                 const Scalar& friction) {
  using std::sqrt;
  const Scalar one = constant<Scalar>(1.0);
  const Scalar up = press + friction;
  const Scalar down = press - friction;
  const Scalar ratio = restitution * sqrt(down / up);
  return speed * (one / up + one / sqrt(up * down)) / (one - ratio);
}

/// First time within `horizon` [s] at which the applied acceleration of a resting body (the path's,
/// without friction) leaves the band [-friction, friction] [m/s^2] in an allowed direction: an
/// Event release, or horizon with direction 0. `evaluations` grows by the evaluations of the path.
///
/// For Path = Flight<double> and RampFlight<double>.
template <class Path>
Event next_release(const Path& applied, double friction, bool may_rise, bool may_fall,
                   double horizon, std::int64_t& evaluations);

}  // namespace ricochet::carrier_track::inline events
