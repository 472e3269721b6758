#pragma once

#include <vector>

#include "ricochet/machine.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline regimes {

/// The regimes of a valid scene of fidelity impact under a disturbance (is_disturbed), up to the
/// first in which a turn has more than `at_most` collisions; see regimes_of(). Not yet doubted for
/// being among others that are not certain.
std::vector<Regime> disturbed_regimes(const Scene& scene, const RegimeOptions& options,
                                      double at_most);

}  // namespace ricochet::carrier_track::inline regimes
