#pragma once

#include <vector>

#include "src/report/chart.h"

namespace ricochet::report {

/// Returns the parts of a joined series between its gaps, as the corners to draw; for steps it adds
/// the corners between samples. Every sample in the result has a value.
std::vector<std::vector<Sample>> polylines(const Series& series);

}  // namespace ricochet::report
