#pragma once

#include "src/report/results.h"
#include "src/studies/calibration/results.h"

namespace ricochet::studies::calibration {

/// What the page shows: values, tables and charts.
report::Results findings_of(const Results& results);

}  // namespace ricochet::studies::calibration
