#include "src/report/outline.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace ricochet::report {
namespace {

/// The sides of a rectangle, in tenths of pixels.
struct Sides {
  int left, right, top, bottom;
};

int tenths(double pixels) {
  return static_cast<int>(std::lround(10 * pixels));
}

std::optional<Sides> sides_of(const Outline& outline) {
  if (!outline.closed || outline.corners.size() != 4) return std::nullopt;
  const Pixel &a = outline.corners[0], &b = outline.corners[1];
  const Pixel &c = outline.corners[2], &d = outline.corners[3];
  const bool along = (a.y == b.y && b.x == c.x && c.y == d.y && d.x == a.x) ||
                     (a.x == b.x && b.y == c.y && c.x == d.x && d.y == a.y);
  if (!along) return std::nullopt;
  return Sides{tenths(std::min(a.x, c.x)), tenths(std::max(a.x, c.x)), tenths(std::min(a.y, c.y)),
               tenths(std::max(a.y, c.y))};
}

Outline outline_of(const Sides& sides) {
  const double left = sides.left / 10.0, right = sides.right / 10.0;
  const double top = sides.top / 10.0, bottom = sides.bottom / 10.0;
  return {{{left, bottom}, {right, bottom}, {right, top}, {left, top}}, true};
}

/// gnuplot draws neighbours a hundredth of a pixel into each other.
bool meet(int end, int start) {
  return std::abs(end - start) <= 1;
}

std::vector<Sides> joined_across(const std::vector<Sides>& all) {
  std::vector<Sides> joined;
  for (const Sides& next : all) {
    if (!joined.empty()) {
      Sides& last = joined.back();
      if (last.top == next.top && last.bottom == next.bottom && meet(last.right, next.left)) {
        last.right = next.right;
        continue;
      }
    }
    joined.push_back(next);
  }
  return joined;
}

std::vector<Sides> joined_up(const std::vector<Sides>& all) {
  std::vector<Sides> joined;
  std::map<std::pair<int, int>, std::size_t> last_between;
  for (const Sides& next : all) {
    const auto [place, is_new] = last_between.try_emplace({next.left, next.right}, joined.size());
    if (!is_new && meet(joined[place->second].top, next.bottom)) {
      joined[place->second].top = next.top;
      continue;
    }
    place->second = joined.size();
    joined.push_back(next);
  }
  return joined;
}

}  // namespace

std::vector<Outline> joined_rectangles(const std::vector<Outline>& outlines) {
  std::vector<Outline> result;
  std::vector<Sides> rectangles;
  for (const Outline& outline : outlines) {
    if (const auto sides = sides_of(outline)) {
      rectangles.push_back(*sides);
    } else {
      result.push_back(outline);
    }
  }
  for (const Sides& sides : joined_up(joined_across(rectangles))) {
    result.push_back(outline_of(sides));
  }
  return result;
}

}  // namespace ricochet::report
