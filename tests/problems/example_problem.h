#pragma once

#include <vector>

#include "problems/carrier_track/questions/machine.h"
#include "problems/family.h"

/// The problem that CONTRIBUTING.md shows how to add.
namespace ricochet::carrier_track {

Family gentle_family(const std::vector<Machine>& machines);

}  // namespace ricochet::carrier_track
