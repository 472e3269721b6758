#pragma once

#include <string>
#include <vector>

#include "src/report/chart.h"

namespace ricochet::report {

/// What surrounds the data of a chart.
struct Frame {
  Range x{0, 1}, y{0, 1}, colours{0, 1};
  std::vector<std::string> legend = {};
  int room_for_ends = 0;  ///< pixels at the right, for labels at the ends of curves
};

/// About as wide as the text is in pixels; gnuplot guesses no better.
int text_width(const std::string& text);

/// Size of the area for the data in pixels, roughly: it only decides how many labels fit.
int plot_width(const Chart& chart, const Frame& frame);
int plot_height(const Chart& chart);

/// The part of the gnuplot script that sets size, title, axes and legend.
std::string frame_script(const Chart& chart, const Frame& frame);

}  // namespace ricochet::report
