#pragma once

#include "problems/carrier_track/regimes/followed_motion.h"
#include "ricochet/regimes.h"

namespace ricochet::carrier_track::inline regimes {

/// A border between two regimes.
template <class Motion>
struct Border {
  double omega;  ///< [rad/s]
  RegimeEnd kind;
  Motion before;  ///< on its nearer side
  Motion after;   ///< at it or just beyond, or where the new motion is first found
};

/// The first border between two motions of different signature, met by following `near` to the
/// speed of `far`, upwards or downwards. Each border is solved as what it is: an impact that passes
/// the counting limit as the root of its margin, a release in closed form, a flip as the root of
/// its eigenvalue condition, a fold by Newton's method on the orbit and that condition; other
/// changes by bisection.
Border<SteadyMotion> first_border(const SteadyMotion& near, const SteadyMotion& far);

/// The same, upwards only. The border may be before `near`: see count_border().
Border<DisturbedMotion> first_border(const DisturbedMotion& near, const DisturbedMotion& far);

}  // namespace ricochet::carrier_track::inline regimes
