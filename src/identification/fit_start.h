#pragma once

#include <vector>

#include "problems/carrier_track/identification/knock_loss.h"
#include "ricochet/random.h"

namespace ricochet::studies::identification {

/// Points from which to fit, the most promising first, at most `most`: constants drawn around the
/// scene's, each with the plate's angle and speed that suit the record best. The first draw is the
/// scene itself.
std::vector<Vector> fit_starts(const carrier_track::KnockLoss& loss, std::size_t most,
                               Random& random);

}  // namespace ricochet::studies::identification
