#pragma once

#include <optional>
#include <string>

#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/regimes/steady_motion.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"

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

/// The border between two settled motions of one kind, `near` at the lower speed, at which the
/// first or the last phase of the disturbance has a turn with more (of the most) or fewer (of the
/// least) collisions. It may be before `near`, where such turns began that no even phase had met.
/// Nothing if these turns cannot be followed.
std::optional<Border<DisturbedMotion>> count_border(const DisturbedMotion& near,
                                                    const DisturbedMotion& far, int rank,
                                                    Extreme extreme);

// The impacts of a disturbed motion over the phases of its disturbance.

/// The margin of an impact at the phase at which it is least or most.
struct PhaseMargin {
  double value;  ///< ln(speed / counting limit), at least lowest_margin
  double phase;  ///< [rad]
};

/// That of the rank-th fastest impact of a turn, rank 1 the fastest; exact near 0, else by a
/// parabola through three phases.
PhaseMargin extreme_margin(const DisturbedMotion& motion, int rank, Extreme extreme);

/// The same of the even phases alone, by the parabola, with the even phase next to it.
PhaseMargin sampled_margin(const DisturbedMotion& motion, int rank, Extreme extreme);

// Where the least or the most count of a disturbed motion changes with the speed. At speeds on one
// side some phases have turns with fewer or more collisions; towards the other side these phases
// become fewer, down to one.

/// The last speed and phase of such turns.
struct PhaseTip {
  double omega;     ///< [rad/s], to some 1e-13, relative
  double phase;     ///< [rad]
  double drift;     ///< [s], of the phases of such turns over the speed, beside the tip
  bool is_reached;  ///< false: there still are such turns at the speed that was searched up to
};

/// Whether the rank-th fastest impact counts (of the most), or does not (of the least), in a turn
/// with that margin.
inline bool is_beyond(Extreme extreme, double margin) {
  return extreme == Extreme::most ? margin > 0 : margin <= 0;
}

/// The tip of the turns of a settled motion in which that is so of the rank-th fastest impact, from
/// one of them at `phase`, towards the speed `until` [rad/s]. Nothing if the turn there is none.
std::optional<PhaseTip> phase_tip(const DisturbedMotion& motion, int rank, Extreme extreme,
                                  double phase, double until);

}  // namespace ricochet::carrier_track::inline regimes
