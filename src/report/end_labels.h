#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "src/report/frame.h"

namespace ricochet::report {

/// What a curve is called, written beside its end at the right of the plot.
struct EndLabel {
  std::string text;
  std::size_t series;  ///< the curve's number
  double end;          ///< of the curve, as a share of the plot's height from the bottom
  double place;        ///< of the label
};

/// The labels of all curves that have one, which then need no legend. Where curves end close to
/// each other, labels are moved apart. None where there are fewer than two or very many, where a
/// curve ends elsewhere than at the right, where labels would lie far from their curves, or take
/// much of the width.
std::vector<EndLabel> end_labels(const Chart& chart, const Frame& frame);

/// Whether labels lie so far from their curves that lines must lead to them.
bool need_leaders(const Chart& chart, const std::vector<EndLabel>& labels);

/// Pixels at the right of the plot that the labels need.
int room_for(const Chart& chart, const std::vector<EndLabel>& labels);

/// Script that writes them, with lines that lead to them where these are needed; `colours` are the
/// curves', by their numbers.
std::string end_label_script(const Chart& chart, const std::vector<EndLabel>& labels,
                             const std::vector<std::string>& colours);

}  // namespace ricochet::report
