#pragma once

#include "problems/carrier_track/regimes/disturbed_motion.h"

/// The impacts of a disturbed motion over the phases of its disturbance.
namespace ricochet::carrier_track::inline regimes {

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

}  // namespace ricochet::carrier_track::inline regimes
