#pragma once

#include <vector>

#include "src/research/calibration/results.h"

namespace ricochet::studies::calibration {

/// Runs the searches of Plan::convergence for
/// - the parameters chosen by the frontier,
/// - those of the default interpretation, if they differ,
/// - all parameters of the best interpretation whose cases share a scene,
/// - and, for fewer evaluations, the best interpretations with the free parameters of the default
///   one, including it.
/// An interpretation is left out if it equals a better one to the last bit at the same parameters:
/// its differences then have no effect.
std::vector<Convergence> long_searches(const Results& results, FitStore& store);

}  // namespace ricochet::studies::calibration
