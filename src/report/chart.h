#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ricochet::report {

enum class Scale { linear, logarithmic };

struct Range {
  double lower, upper;
};

struct Axis {
  std::string label = {};  ///< with its unit: "speed [rad/s]"
  Scale scale = Scale::linear;
  std::optional<Range> range = {};  ///< if missing, the data and the reference lines determine it
  /// Names of the positions 0, 1, ... of an axis that has names instead of numbers. Only a heat map
  /// may have them on y, counted from the bottom.
  std::vector<std::string> categories = {};
};

/// One value of a series.
struct Sample {
  double position;
  std::optional<double> value;       ///< if missing: a gap
  std::optional<Range> spread = {};  ///< around the value: a band of a line, a bar of a point
  std::string name = {};             ///< written beside a point if there is room
};

enum class Mark {
  line,   ///< samples joined
  steps,  ///< a value holds until the next sample
  points
};

struct Series {
  std::string label;  ///< its entry in the legend; empty: no entry
  Mark mark = Mark::line;
  std::vector<Sample> samples = {};  ///< by rising position between gaps, if joined
  bool pale = false;                 ///< grey: a background for comparison
  bool dark = false;                 ///< nearly black: to be seen on coloured areas
};

/// A coloured area below the series.
struct Area {
  struct Edge {
    double position;
    Range between;
  };

  std::string label;            ///< its entry in the legend; empty: no entry
  std::optional<double> shade;  ///< its place in the palette of heat maps; if missing: hatched
  std::vector<std::vector<Edge>> parts;  ///< each by rising position
  std::string name = {};                 ///< written into it, if it has room
};

/// Coloured cells over the categories of x and y. A cell without a value is hatched.
struct HeatMap {
  std::string label;  ///< of the colours, with its unit
  std::vector<std::vector<std::optional<double>>> rows =
      {};                           ///< a row for each category of y, a cell for each category of x
  std::optional<Range> range = {};  ///< of the colours, for maps that are compared
  /// Where the cells lead: what stands in a link for the row and for the column, joined. In the
  /// order of the axes; empty: nowhere.
  std::vector<std::string> row_links = {}, column_links = {};
};

enum class Direction { vertical, horizontal };

/// A line across the whole plot. Lines of one label share their look and their legend entry.
struct ReferenceLine {
  Direction direction;
  double position;
  std::string label;
};

/// The content of a chart; the renderer decides how it looks. Either series or a heat map, not
/// both.
struct Chart {
  std::string name;  ///< the file's stem: lower-case letters, digits and hyphens; unique on a page
  std::string title = {};
  Axis x = {}, y = {};
  std::vector<Series> series = {};
  std::vector<Area> areas = {};  ///< not below a heat map
  std::optional<HeatMap> heat_map = {};
  std::vector<ReferenceLine> lines = {};
  int width = 480, height = 320;  ///< pixels; the picture is larger if the content needs more room
  std::string description = {};   ///< for readers who cannot see it; empty: made from the labels
};

/// Throws std::invalid_argument, one line with place and reason, unless the chart can be
/// drawn: finite numbers of at most 1e100, of at least 1e-300 on logarithmic axes, categories that
/// match.
void check(const Chart& chart);

inline bool has_cell_links(const Chart& chart) {
  return chart.heat_map && !chart.heat_map->row_links.empty();
}

/// The description, or one made from the labels.
std::string description(const Chart& chart);

/// The numbers of a chart as a CSV file: a row for every sample, edge of an area, reference line or
/// cell, with the axes' labels as the names of the columns and up to ten significant digits. What
/// is missing is an empty field.
std::string csv_of(const Chart& chart);

}  // namespace ricochet::report
