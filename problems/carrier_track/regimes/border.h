#pragma once

#include <optional>
#include <string>

#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/regimes/steady_motion.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline regimes {

/// A border between two regimes of motions that repeat.
struct Border {
  double omega;  ///< [rad/s]
  RegimeEnd kind;
  SteadyMotion before;  ///< on its nearer side
  SteadyMotion after;   ///< at it or just beyond, or where the new motion is first found
};

/// The first border between two motions of different signature, met by following `near` to the
/// speed of `far`, upwards or downwards. Each border is solved as what it is: an impact that passes
/// the counting limit as the root of its margin, a release in closed form, a flip as the root of
/// its eigenvalue condition, a fold by Newton's method on the orbit and that condition; other
/// changes by bisection.
Border first_border(const SteadyMotion& near, const SteadyMotion& far);

/// The speed [rad/s] of the fold at which an orbit that never rests vanishes: the zero of what the
/// orbit misses its start by, and of its fold margin, by Newton's method from an orbit nearby.
/// Nothing if that does not converge within 1 % of the speed.
std::optional<double> fold_near(const SteadyMotion& orbit);

/// Whether a margin keeps its sign over a step, by the cubic through the values and slopes at both
/// ends. The cubic's error is of the size of `surprise`, the difference between the rise and what
/// the slopes say, and of a share of how far its extremum is from the nearer end.
bool keeps_sign(const Margin& a, const Margin& b, double step);

/// How much more [m/s^2] than friction holds back the forces push a body that stays at `position`,
/// at most, in a direction that no wall blocks: it moves at some time if that is > 0. Forces that
/// do not repeat come as near to the sum of their amplitudes as one likes.
double release_margin(const Scene& scene, double position);

/// That margin with its exact derivatives with respect to the speed and to a constant (see
/// continuation_constants). A body on a wall stays on it.
struct ReleaseSlopes {
  double value;          ///< [m/s^2]
  double over_omega;     ///< per rad/s
  double over_constant;  ///< per unit of the constant
};
ReleaseSlopes release_slopes(const Scene& scene, double position, const std::string& constant);

}  // namespace ricochet::carrier_track::inline regimes
