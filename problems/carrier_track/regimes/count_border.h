#pragma once

#include <optional>

#include "problems/carrier_track/regimes/border.h"

namespace ricochet::carrier_track::inline regimes {

/// The border between two settled motions of one kind, `near` at the lower speed, at which the
/// first or the last phase of the disturbance has a turn with more (of the most) or fewer (of the
/// least) collisions. It may be before `near`, where such turns began that no even phase had met.
/// Nothing if these turns cannot be followed.
std::optional<Border<DisturbedMotion>> count_border(const DisturbedMotion& near,
                                                    const DisturbedMotion& far, int rank,
                                                    Extreme extreme);

}  // namespace ricochet::carrier_track::inline regimes
