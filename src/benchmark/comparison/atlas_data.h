#pragma once

#include "src/benchmark/analysis/cell_results.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

/// Returns the failure atlas: for each machine and perturbation, the share of runs that solved
/// their problem, with Wilson's interval, the outcomes of the other runs, and a command that
/// repeats one of them. Also returns the largest budget of each problem.
report::Json atlas_data(const Campaign& campaign, const std::vector<CellResult>& results);

}  // namespace ricochet::studies::comparison
