#pragma once

#include <cstddef>
#include <vector>

#include "src/report/chart.h"
#include "src/report/path_data.h"

namespace ricochet::report {

/// Returns the indices of the corners that suffice to draw a line (Douglas and Peucker,
/// Cartographica 10 (1973) 112): the other corners lie at most `tolerance` from it. Both ends are
/// kept.
std::vector<std::size_t> needed_corners(const std::vector<Pixel>& line, double tolerance);

/// Returns the samples that suffice to draw a line through all, with at most an error of `across`
/// in position and `up` in value, both > 0. Every sample must have a value.
std::vector<Sample> simplified(const std::vector<Sample>& samples, double across, double up);

}  // namespace ricochet::report
