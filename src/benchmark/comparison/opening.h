#pragma once

#include <string>

#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// The first sentences of a comparison's report: which solver, how sure, on how many problems. Of
/// the rows of leader_data() those with the largest budgets.
std::string opening_of(const report::Json& leaders);

}  // namespace ricochet::studies::comparison
