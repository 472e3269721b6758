#include "src/report/simplified.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ricochet::report {
namespace {

/// Distance of a point from the line between two others.
double distance(const Pixel& point, const Pixel& from, const Pixel& to) {
  const double across = to.x - from.x, down = to.y - from.y;
  const double length = across * across + down * down;
  const double x = point.x - from.x, y = point.y - from.y;
  const double along = length > 0 ? std::clamp((x * across + y * down) / length, 0.0, 1.0) : 0;
  return std::hypot(x - along * across, y - along * down);
}

}  // namespace

std::vector<std::size_t> needed_corners(const std::vector<Pixel>& line, double tolerance) {
  if (line.empty()) return {};
  std::vector<bool> kept(line.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double farthest = tolerance;
    std::size_t corner = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double far = distance(line[i], line[first], line[last]);
      if (far > farthest) {
        farthest = far;
        corner = i;
      }
    }
    if (corner == first) continue;
    kept[corner] = true;
    open.insert(open.end(), {{first, corner}, {corner, last}});
  }
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (kept[i]) corners.push_back(i);
  return corners;
}

std::vector<Sample> simplified(const std::vector<Sample>& samples, double across, double up) {
  std::vector<Pixel> line;
  for (const Sample& sample : samples)
    line.push_back({sample.position / across, *sample.value / up});
  std::vector<Sample> kept;
  for (const std::size_t i : needed_corners(line, 1)) kept.push_back(samples[i]);
  return kept;
}

}  // namespace ricochet::report
