#pragma once

#include "problems/carrier_track/questions/machine.h"
#include "src/core/question.h"

/// The question that CONTRIBUTING.md shows how to add.
namespace ricochet::carrier_track {

Question gentle_question(const Machine& machine);

}  // namespace ricochet::carrier_track
