#pragma once

#include "src/benchmark/analysis/comparison.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

/// Bias of entries towards the ends or the middle of the box: the share of runs that each solves of
/// the relocated-optimum variants with the best point at the lower end, in the middle and at the
/// upper end, for every part of the plan that relocates the optimum: in `relocated_optima` a row
/// for each entry, in `relocated` the number of problems and of variables.
report::Json relocated_optimum_data(const Campaign& campaign,
                                    const std::vector<CellResult>& results);

}  // namespace ricochet::studies::comparison
