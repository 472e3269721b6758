#pragma once

#include <vector>

#include "problems/carrier_track/questions/machine.h"
#include "src/core/question.h"

/// The speed with the fewest collisions.
namespace ricochet::carrier_track::inline questions {

/// Minimise the collision count over the speed: an integer staircase, no derivatives. The smooth
/// surrogate has them.
Question count_question(const Machine& machine);

}  // namespace ricochet::carrier_track::inline questions
