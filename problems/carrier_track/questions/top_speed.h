#pragma once

#include <string>

#include "problems/carrier_track/questions/machine.h"
#include "src/core/question.h"

/// The fastest quiet speed.
namespace ricochet::carrier_track::inline questions {

/// Minimise -speed subject to count <= quiet limit, without derivatives. The surrogate, which has
/// them, must stay below the half_level of the limit.
Question top_speed_question(const Machine& machine);

/// The same in another family, whose name its own begins with.
Question top_speed_question_of(const std::string& family, const Machine& machine);

}  // namespace ricochet::carrier_track::inline questions
