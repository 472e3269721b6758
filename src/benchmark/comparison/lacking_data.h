#pragma once

#include <vector>

#include "ricochet/solvers.h"
#include "src/benchmark/experiment/campaign/plan.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// Rows of solver and library: those of `missing` that a part of the plan would have selected.
report::Json lacking_data(const Plan& plan, const std::vector<MissingSolver>& missing);

}  // namespace ricochet::studies::comparison
