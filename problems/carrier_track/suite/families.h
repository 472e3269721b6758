#pragma once

#include <vector>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/problem.h"

/// The problems of the carrier track, all from the single objective of count.h.
namespace ricochet::carrier_track::inline problems {

/// Every family of problems, for these machines.
std::vector<Family> families_of(const std::vector<Machine>& machines);

/// Every family of the cases in the default interpretation, and the calibration of that
/// interpretation.
std::vector<Family> case_families();

}  // namespace ricochet::carrier_track::inline problems
