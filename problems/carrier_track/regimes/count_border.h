#pragma once

#include <optional>

#include "problems/carrier_track/regimes/border.h"
#include "problems/carrier_track/regimes/disturbed_motion.h"

namespace ricochet::carrier_track::inline regimes {

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

}  // namespace ricochet::carrier_track::inline regimes
