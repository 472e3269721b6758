#pragma once

#include <string>
#include <vector>

#include "src/report/chart.h"
#include "src/report/end_labels.h"
#include "src/report/path_data.h"
#include "src/report/ticks.h"

namespace ricochet::report {

/// An entry of the legend, of area, series or line number `index`.
struct LegendEntry {
  enum class Of { area, series, line, cells_without_value } of;
  std::size_t index;
  std::string label;
  Pixel place = {};  ///< of the sample's left end, on the text's base line
};

/// The parts around the data of a chart, and their positions.
struct Frame {
  int width, height;  ///< of the picture: the chart's, or the least that the data need
  Box plot;           ///< the area for the data
  std::vector<std::string> title;
  Range x{0, 1}, y{0, 1}, colours{0, 1};
  std::vector<Tick> x_ticks, y_ticks, colour_ticks;
  bool names_turned = false;  ///< of the ticks of x
  bool names_above = false;   ///< they stand above a heat map, too, so that a long one can be read
  std::string x_label, y_label, colour_label;
  double below_ticks = 0;  ///< base line of the label of x
  std::vector<LegendEntry> legend;
  std::vector<EndLabel> ends;
};

Frame frame_of(const Chart& chart);

/// Returns the labels of reference lines, without duplicates.
std::vector<std::string> line_labels(const Chart& chart);

/// Returns the pixel of a position and a value; points far outside the plot are moved closer.
Pixel place_of(const Chart& chart, const Frame& frame, double position, double value);

inline constexpr int title_size = 14;    ///< pixels
inline constexpr int title_height = 18;  ///< of a line
inline constexpr int key_width = 22;     ///< of a legend's sample
inline constexpr int bar_gap = 14;       ///< between a heat map and the bar of its colours
inline constexpr int bar_width = 20;
inline constexpr int name_angle = 35;  ///< of turned names, degrees

}  // namespace ricochet::report
