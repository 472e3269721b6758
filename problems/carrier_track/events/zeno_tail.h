#pragma once

#include <cmath>

#include "ricochet/scalar.h"

namespace ricochet::carrier_track::inline events {

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

}  // namespace ricochet::carrier_track::inline events
