#pragma once

#include <cmath>
#include <optional>
#include <vector>

namespace ricochet::studies::surrogate {

struct Point {
  double x, y;
};

/// Slope of the line through finite points by least squares; nothing for fewer than three points,
/// or if all x are equal.
inline std::optional<double> slope_of(const std::vector<Point>& points) {
  if (points.size() < 3) return std::nullopt;
  double x = 0;
  double y = 0;
  for (const Point& point : points) {
    x += point.x / static_cast<double>(points.size());
    y += point.y / static_cast<double>(points.size());
  }
  double square = 0;
  double product = 0;
  for (const Point& point : points) {
    square += (point.x - x) * (point.x - x);
    product += (point.x - x) * (point.y - y);
  }
  if (square == 0) return std::nullopt;
  return product / square;
}

}  // namespace ricochet::studies::surrogate
