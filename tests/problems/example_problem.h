#pragma once

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/problem.h"

/// The problem that CONTRIBUTING.md shows how to add.
namespace ricochet::carrier_track {

Problem gentle_problem(const Machine& machine);

}  // namespace ricochet::carrier_track
