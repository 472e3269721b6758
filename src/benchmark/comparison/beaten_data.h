#pragma once

#include <vector>

#include "src/benchmark/analysis/cell_results.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// The problems whose best known value a run is below by more than the problem's tolerance: an
/// error of the suite, since no such run can be scored rightly. A row for each, with the best run
/// and the number of runs below.
report::Json beaten_data(const Campaign& campaign,
                         const std::vector<ricochet::comparison::CellResult>& results);

}  // namespace ricochet::studies::comparison
