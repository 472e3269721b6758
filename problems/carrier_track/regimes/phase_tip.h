#pragma once

#include <optional>

#include "problems/carrier_track/regimes/disturbed_motion.h"

/// Where the least or the most count of a disturbed motion changes with the speed. At speeds on one
/// side some phases have turns with fewer or more collisions; towards the other side these phases
/// become fewer, down to one.
namespace ricochet::carrier_track::inline regimes {

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
