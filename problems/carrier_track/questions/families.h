#pragma once

#include <vector>

#include "problems/carrier_track/questions/machine.h"
#include "problems/family.h"

/// The questions put to solvers, all from the one objective of collisions.h.
namespace ricochet::carrier_track::inline questions {

/// Every family that a machine can be put to.
std::vector<Family> families_of(const std::vector<Machine>& machines);

/// Every family of the cases in the default reading, and the calibration of that reading.
std::vector<Family> case_families();

}  // namespace ricochet::carrier_track::inline questions
