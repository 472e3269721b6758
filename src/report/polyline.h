#pragma once

#include <vector>

#include "src/report/chart.h"

namespace ricochet::report {

/// Whether the samples have the same value and the same spread: a line between them is level.
bool same_height(const Sample& a, const Sample& b);

/// The parts of a joined series between its gaps, as the corners to draw. Lines lose the midst of
/// what is level; steps get the corners between their samples and lose those that repeat the last
/// value. Every sample here has a value.
std::vector<std::vector<Sample>> polylines(const Series& series);

}  // namespace ricochet::report
