#pragma once

#include <compare>
#include <vector>

namespace ricochet::report {

/// A place on a picture, in pixels from its upper left corner.
struct Pixel {
  double x, y;
  auto operator<=>(const Pixel&) const = default;
};

/// A line through corners, or the edge of an area, or a circle around its only corner.
struct Outline {
  std::vector<Pixel> corners;
  bool closed = false;
  double radius = 0;  ///< > 0: a circle
  auto operator<=>(const Outline&) const = default;
};

/// Those of the outlines that are rectangles along the axes, joined where two share a whole edge:
/// first across, then up. What they cover stays as it was.
std::vector<Outline> joined_rectangles(const std::vector<Outline>& outlines);

}  // namespace ricochet::report
