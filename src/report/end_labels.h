#pragma once

#include <string>
#include <vector>

#include "src/report/frame.h"

namespace ricochet::report {

/// What a curve is called, written beside its end at the right of the plot.
struct EndLabel {
  std::string text;
  double value;  ///< of the curve's last sample
  double place;  ///< of the label, as a share of the plot's height from the bottom
};

/// The labels of all curves that have one, which then need no legend. None where there are fewer
/// than two, where a curve ends elsewhere than at the right, where labels would collide, or lie
/// far from their curves, and where they would take much of the width.
std::vector<EndLabel> end_labels(const Chart& chart, const Frame& frame);

/// Script that writes them.
std::string end_label_script(const std::vector<EndLabel>& labels);

}  // namespace ricochet::report
