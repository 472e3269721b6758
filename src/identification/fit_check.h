#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/identification/knock_loss.h"
#include "ricochet/solver.h"
#include "src/identification/knock_fit.h"
#include "src/report/chart.h"

namespace ricochet::studies::identification {

/// What the record contradicts at the fit, one sentence each, with by how much. Empty: the
/// intervals may be trusted. Tested are the residuals of times and logarithms of strengths by wall
/// and speed of the plate, the shares of spurious and missed knocks, and lag, clock and mark angle
/// against their prior knowledge: as fitted, and in a fit that does without it.
std::vector<std::string> contradictions(const carrier_track::KnockLoss& loss, const KnockFit& fit,
                                        const Solver& solver);

/// Two charts of how the point x explains a record: how much later than the nearest predicted
/// impact each knock is, against time; and the plate's angle at each knock, recorded or predicted,
/// against time.
std::vector<report::Chart> knock_charts(const carrier_track::KnockLoss& loss, const Vector& x);

}  // namespace ricochet::studies::identification
