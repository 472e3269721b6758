#pragma once

#include "src/benchmark/analysis/comparison.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// Returns the runs that failed with an error or were ended from outside: a row for each cell and
/// kind of failure, with the command that repeats the first of them.
report::Json failure_data(const ricochet::comparison::Comparison& comparison);

}  // namespace ricochet::studies::comparison
