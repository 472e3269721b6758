#pragma once

#include "problems/carrier_track/regimes/disturbed_motion.h"

/// Where the least or the most count of a disturbed motion changes with the speed. At speeds on one
/// side some phases have turns with fewer or more collisions; towards the other side these phases
/// become fewer, down to one.
namespace ricochet::carrier_track::inline regimes {

/// Whether the rank-th fastest impact of a turn counts (of the most), or does not (of the least).
inline bool is_beyond(const DisturbedTurn& turn, int rank, Extreme extreme) {
  return extreme == Extreme::most ? turn.collisions >= rank : turn.collisions < rank;
}

/// Whether that is so of some turn of a settled motion.
inline bool has_beyond(const DisturbedMotion& motion, int rank, Extreme extreme) {
  return extreme == Extreme::most ? motion.most >= rank : motion.least < rank;
}

/// The last speed and phase of such turns.
struct PhaseTip {
  double omega;     ///< [rad/s]; to some 1e-13, relative, if smooth, else to 1e-6
  double phase;     ///< [rad]
  bool is_reached;  ///< false: there still are such turns at the speed that was searched up to
  bool is_smooth;   ///< the impact passes the counting limit; false: it appears or vanishes
};

/// The tip of such turns of a settled motion that has some, towards the speed of another that knows
/// none.
PhaseTip phase_tip(const DisturbedMotion& motion, const DisturbedMotion& other, int rank,
                   Extreme extreme);

}  // namespace ricochet::carrier_track::inline regimes
