#pragma once

#include <string>

#include "src/report/chart.h"

namespace ricochet::report {

/// Returns the chart as a self-contained SVG, reproducible byte by byte; ids start with the chart's
/// name, so that several fit into one page. Throws std::invalid_argument as check() does.
std::string to_svg(const Chart& chart);

}  // namespace ricochet::report
