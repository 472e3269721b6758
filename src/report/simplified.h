#pragma once

#include <vector>

#include "src/report/chart.h"

namespace ricochet::report {

/// The corners of a line that are enough to draw it (Douglas and Peucker, Cartographica 10 (1973)
/// 112): what is left out lies no farther from it than a distance of 1, where `across` of the
/// position and `up` of the value, both > 0, are a distance of 1. Keeps the ends. Every sample must
/// have a value.
std::vector<Sample> simplified(const std::vector<Sample>& samples, double across, double up);

}  // namespace ricochet::report
