#pragma once

#include <vector>

#include "ricochet/problem.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline counting {

/// The ranges of speeds [rad/s] from `lowest` to `highest`, both > 0, in which a count of at most
/// `most` is not excluded by scan_completely(): because a speed has such a count, or because the
/// scan would take too many simulations there. By increasing speed, apart from each other. The
/// scene is valid, with fidelity impact and the rule of impacts; else std::invalid_argument is
/// thrown.
std::vector<CoordinateRange> not_excluded(const Scene& scene, double lowest, double highest,
                                          double most);

}  // namespace ricochet::carrier_track::inline counting
