#pragma once

#include <compare>
#include <string>
#include <vector>

namespace ricochet::report {

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
