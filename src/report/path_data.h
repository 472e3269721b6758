#pragma once

#include <string>
#include <vector>

#include "src/report/outline.h"

namespace ricochet::report {

/// Outlines as the data of an SVG path, in few characters: rounded to a tenth of a pixel, each
/// corner from the one before, so that rounding does not add up; of open lines only the corners
/// without which they would be off by more than a tenth of a pixel. A line of one corner becomes a
/// dot, which a round cap makes visible. Of those that lie on each other to a tenth of a pixel one
/// is drawn.
std::string path_data(const std::vector<Outline>& outlines);

/// A number of pixels with at most one decimal.
std::string in_pixels(double pixels);

}  // namespace ricochet::report
