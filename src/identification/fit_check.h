#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/identification/knock_loss.h"
#include "ricochet/solver.h"
#include "src/identification/knock_fit.h"

namespace ricochet::studies::identification {

/// What the record contradicts at the fit, one sentence each, with by how much. Empty: the
/// intervals may be trusted. Tested are the residuals of times and logarithms of strengths by wall
/// and speed of the plate, the shares of spurious and missed knocks, and lag, clock and mark angle
/// against their prior knowledge: as fitted, and in a fit that does without it.
std::vector<std::string> contradictions(const carrier_track::KnockLoss& loss, const KnockFit& fit,
                                        const Solver& solver);

}  // namespace ricochet::studies::identification
