#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "src/report/chart.h"

namespace ricochet::report {

/// A curve's label, written beside its end at the right of the plot.
struct EndLabel {
  std::string text;
  std::size_t series;  ///< the curve's number
  double end;          ///< of the curve, as a share of the plot's height from the bottom
  double place;        ///< of the label
};

/// Returns the labels of all curves that have one; they replace the legend. x and y are the limits
/// of the axes, and the plot is `height` pixels high. Labels of curves that end close together are
/// moved apart. Returns none if there are fewer than two or very many, if a curve does not end at
/// the right, if labels would lie far from their curves, or if they would take much of the width.
std::vector<EndLabel> end_labels(const Chart& chart, const Range& x, const Range& y, double height);

/// Returns true if labels lie so far from their curves that they need leader lines.
bool need_leaders(const std::vector<EndLabel>& labels, double height);

/// Width of a leader line in pixels.
inline constexpr int leader_width = 18;

}  // namespace ricochet::report
