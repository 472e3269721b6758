#pragma once

#include <vector>

#include "src/studies/calibration/results.h"

namespace ricochet::studies::calibration {

/// The searches that Plan::convergence of results so far asks for, of
///   the constants that the frontier chooses,
///   those of the default reading, where they are others,
///   all constants of the best reading whose cases share a scene,
/// and, less long, of the best of the readings that are as free as the default one, it included. A
/// reading that is as good as a better one at the same constants, to the last bit, owes nothing to
/// what it differs in and is left out.
std::vector<Convergence> long_searches(const Results& results, FitStore& store);

}  // namespace ricochet::studies::calibration
