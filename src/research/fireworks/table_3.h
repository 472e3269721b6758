#pragma once

#include "src/report/json.h"

namespace ricochet::studies::fireworks {

/// The functions of Tan and Zhu's Table 3 in 30 dimensions with 10,000 evaluations, begun where
/// they began, by the readings of the algorithm; beside what they published.
report::Json table_3_data(int runs);

}  // namespace ricochet::studies::fireworks
