#pragma once

#include <compare>
#include <string>
#include <vector>

#include "src/report/chart.h"

namespace ricochet::report {

/// Returns the chart as a self-contained SVG, reproducible byte by byte; ids start with the chart's
/// name, so that several fit into one page. Throws std::invalid_argument as check() does.
std::string to_svg(const Chart& chart);

/// Returns the parts of a joined series between its gaps, as the corners to draw; for steps it adds
/// the corners between samples. Every sample in the result has a value.
std::vector<std::vector<Sample>> polylines(const Series& series);

/// A place on a picture, in pixels from its upper left corner.
struct Pixel {
  double x, y;
  auto operator<=>(const Pixel&) const = default;
};

/// A rectangle on a picture; top < bottom, since pixels count downwards.
struct Box {
  double left, right, top, bottom;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
  bool holds(const Pixel& place) const {
    return left <= place.x && place.x <= right && top <= place.y && place.y <= bottom;
  }
};

/// A line through corners, or the edge of an area, or a circle around its only corner.
struct Outline {
  std::vector<Pixel> corners;
  bool closed = false;
  double radius = 0;  ///< > 0: a circle
  auto operator<=>(const Outline&) const = default;
};

/// Returns outlines as compact SVG path data: rounded to a tenth of a pixel, relative to the
/// previous corner without accumulated rounding. Corners of open lines are omitted if that moves
/// the line by at most a tenth of a pixel. A line of one corner becomes a dot, which a round cap
/// makes visible. Of outlines that coincide to a tenth of a pixel one is drawn.
std::string path_data(const std::vector<Outline>& outlines);

}  // namespace ricochet::report
