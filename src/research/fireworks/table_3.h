#pragma once

#include "src/report/json.h"

namespace ricochet::studies::fireworks {

/// The functions of Tan and Zhu's Table 3 in 30 dimensions with 10,000 evaluations, from their
/// start, with the interpretations of the algorithm; compared with their published results.
report::Json table_3_data(int runs);

}  // namespace ricochet::studies::fireworks
