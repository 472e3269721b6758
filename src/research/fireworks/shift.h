#pragma once

#include "src/report/json.h"

namespace ricochet::studies::fireworks {

/// How far from the best value every member of the family ends on Sphere, in 30 dimensions with
/// 10,000 evaluations, as the optimum moves away from the origin.
report::Json shift_data(int runs);

}  // namespace ricochet::studies::fireworks
