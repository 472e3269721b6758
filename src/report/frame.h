#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "src/report/chart.h"
#include "src/report/svg.h"

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

struct Tick {
  double position;
  std::string label;  ///< empty: a minor tick
};

/// Limits that leave a little room around the values; all of them if there are none.
Range limits(const std::vector<double>& values, Scale scale);

/// Where a value lies between the limits: 0 at the lower one, 1 at the upper one.
double share(double value, const Range& limits, Scale scale);

/// Returns about `wanted` round numbers on a linear axis. Axes of whole numbers get no fractions.
std::vector<Tick> linear_ticks(const Range& limits, int wanted, bool whole_numbers);

/// About `wanted` labels on a logarithmic axis, and minor ticks.
std::vector<Tick> logarithmic_ticks(const Range& limits, int wanted);

/// A number as a reader writes it, with up to ten digits: −0.5, 2000000, 3×10⁻⁷.
std::string number_label(double number);

/// An entry of the legend.
struct LegendEntry {
  enum class Of { area, series, line, cells_without_value } of;
  std::vector<std::size_t> numbers;  ///< one, but of series that look alike all
  std::vector<std::string> lines;    ///< of the text
  Pixel place = {};                  ///< of the sample's left end, on the first line's base line
};

/// The label of an axis or of colours.
struct AxisLabel {
  std::vector<std::string> lines;
  Pixel place;   ///< of the middle of the first line's base line
  bool upright;  ///< reads upwards
};

/// The parts around the data of a chart, and their positions.
struct Frame {
  int width, height;  ///< of the picture: the chart's, or the least that data and texts need
  Box plot;           ///< the area for the data
  std::vector<std::string> title;
  Range x{0, 1}, y{0, 1}, colours{0, 1};
  std::vector<Tick> x_ticks, y_ticks, colour_ticks;
  bool names_turned = false;  ///< of the ticks of x
  bool names_above = false;   ///< they stand above a heat map, too, so that a long one can be read
  std::vector<AxisLabel> labels;
  std::vector<LegendEntry> legend;
  std::vector<EndLabel> ends;
};

/// Long labels are broken into lines, and the picture grows where texts need room; only names of
/// positions that would take more than 420 pixels are shortened. In the legend stands what is seen
/// within the plot; series that lie within two pixels of each other share an entry. Limits of
/// colours with values on both sides of zero are symmetric.
Frame frame_of(const Chart& chart);

/// Returns the labels of reference lines, without duplicates.
std::vector<std::string> line_labels(const Chart& chart);

/// Returns the pixel of a position and a value; points far outside the plot are moved closer.
Pixel place_of(const Chart& chart, const Frame& frame, double position, double value);

inline constexpr int title_size = 14;    ///< pixels
inline constexpr int title_height = 18;  ///< of a line
inline constexpr int line_height = 15;   ///< of other texts of several lines
inline constexpr int key_width = 22;     ///< of a legend's sample
inline constexpr int bar_gap = 14;       ///< between a heat map and the bar of its colours
inline constexpr int bar_width = 20;
inline constexpr int name_angle = 35;  ///< of turned names, degrees

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
