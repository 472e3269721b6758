#pragma once

#include "src/report/json.h"

namespace ricochet::studies::fireworks {

/// Error of every member of the family on Sphere, in 30 dimensions with 10,000 evaluations, over
/// the distance of the optimum from the origin.
report::Json shift_data(int runs);

}  // namespace ricochet::studies::fireworks
