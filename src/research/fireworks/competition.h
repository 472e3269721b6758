#pragma once

#include "src/report/json.h"

namespace ricochet::studies::fireworks {

/// Tan and Zhu's program, the corrected one, EFWA, dynFWA, BBFWA, LoTFWA, MGFWA and FWASSP on six
/// functions of the competition of CEC 2013, in 30 dimensions, with the results of other
/// implementations. No rows in a build without pagmo.
report::Json competition_data(int runs, std::int64_t evaluations);

}  // namespace ricochet::studies::fireworks
