#pragma once

#include <string>

#include "src/report/chart.h"
#include "src/report/frame.h"

namespace ricochet::report {

/// The part of the gnuplot script that writes the names of points beside them, those of the first
/// series first. Near its dot where there is room; else farther away with a line that leads there,
/// or not at all if the series is pale or there is no room either.
std::string names_of_points(const Chart& chart, const Frame& frame);

}  // namespace ricochet::report
