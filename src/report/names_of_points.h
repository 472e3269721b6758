#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/report/chart.h"
#include "src/report/frame.h"

namespace ricochet::report {

/// The name of a point, written beside it.
struct PointName {
  std::string text;
  Pixel dot;
  Pixel place;       ///< of the end of the text that is nearer to the dot, at half its height
  bool to_the_left;  ///< of its place
  bool led;          ///< far enough away to need a leader line
  bool pale;
};

/// Returns the names of points that fit, those of the first series first: near the dot, or else
/// farther away with a leader line, but not for a pale series.
std::vector<PointName> names_of_points(const Chart& chart, const Frame& frame);

}  // namespace ricochet::report
