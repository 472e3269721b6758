#pragma once

#include "src/report/json.h"
#include "src/research/limits/results.h"

namespace ricochet::studies::limits {

/// The fronts: corners and curves, of the main interpretation and of the others, and the similarity
/// of the fronts of several seeds.
report::Json front_data(const Results& results);

}  // namespace ricochet::studies::limits
