#pragma once

#include <functional>
#include <vector>

#include "src/studies/calibration/appraisal.h"

namespace ricochet::studies::trials {

/// The counts of a case at any speed.
using CountsOfCase = std::function<carrier_track::CountAt(const carrier_track::Case&)>;

/// C1..C12, each with its counts at speeds `step` [rad/s] apart up to 18 rad/s, and the six parts
/// of its score.
std::vector<calibration::CaseAppraisal> judged(const CountsOfCase& counts, double step);

/// The share of those speeds at which two counts of the same case differ.
double differing_share(const carrier_track::SpeedScan& a, const carrier_track::SpeedScan& b);

}  // namespace ricochet::studies::trials
