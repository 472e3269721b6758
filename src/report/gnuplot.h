#pragma once

#include <string>
#include <vector>

#include "src/report/chart.h"

namespace ricochet::report {

/// The chart as a self-contained SVG, the same bytes every time; ids start with the chart's name,
/// so that several can be put into one page. Throws std::invalid_argument as check() does, and
/// std::runtime_error where gnuplot is missing or fails, with what it said.
std::string to_svg(const Chart& chart);

/// The same for several, in parallel.
std::vector<std::string> to_svgs(const std::vector<Chart>& charts);

}  // namespace ricochet::report
