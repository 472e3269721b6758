#pragma once

#include <cmath>

#include "problems/carrier_track/scene/scalar.h"

namespace ricochet::carrier_track::inline events {

/// Time [s] that the infinitely many hops of a body take which leaves a wall with `speed` > 0 [m/s]
/// while it is pressed to it with `press` > `friction` [m/s^2], both constant. Each hop slows by
/// press + friction and falls by press - friction: a geometric series.
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

}  // namespace ricochet::carrier_track::inline events
