#include "src/report/painted_areas.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "src/report/look.h"
#include "src/report/wrapped.h"

namespace ricochet::report {
namespace {

constexpr int name_size = 12;    // pixels
constexpr double name_step = 4;  // between places that are tried, pixels
constexpr double name_room = 2;  // on each side of a name

/// Pale enough for lines and names on top.
Brush brush_of_area(const Area& area, Drawing& drawing) {
  if (!area.shade) return {.fill = drawing.hatching()};
  return {.fill = palette_colour(*area.shade), .opacity = "0.7"};
}

Outline outline_of_part(const std::vector<Area::Edge>& part, const Chart& chart,
                        const Frame& frame) {
  Outline outline{{}, true};
  for (const Area::Edge& edge : part) {
    outline.corners.push_back(place_of(chart, frame, edge.position, edge.between.lower));
  }
  for (auto edge = part.rbegin(); edge != part.rend(); ++edge) {
    outline.corners.push_back(place_of(chart, frame, edge->position, edge->between.upper));
  }
  return outline;
}

/// A place for a name, and the least room around it.
struct NamePlace {
  Pixel place;
  double room;  ///< pixels, from the name's middle to the nearest border of its area
};

/// A part of an area at one position, within the plot [pixels].
struct Side {
  double x, top, bottom;
};

/// A part of an area, at positions that are close to each other.
std::vector<Side> sides_of(const std::vector<Area::Edge>& part, const Chart& chart,
                           const Frame& frame) {
  const auto side_at = [&](const Area::Edge& edge) {
    const Pixel low = place_of(chart, frame, edge.position, edge.between.lower);
    const Pixel high = place_of(chart, frame, edge.position, edge.between.upper);
    return Side{low.x, high.y, low.y};
  };
  std::vector<Side> sides = {side_at(part.front())};
  for (std::size_t i = 1; i < part.size(); ++i) {
    const Side from = sides.back(), to = side_at(part[i]);
    const int steps = std::max(1, static_cast<int>((to.x - from.x) / name_step));
    for (int k = 1; k <= steps; ++k) {
      const double share = static_cast<double>(k) / steps;
      sides.push_back({from.x + share * (to.x - from.x), from.top + share * (to.top - from.top),
                       from.bottom + share * (to.bottom - from.bottom)});
    }
  }
  std::erase_if(sides, [&](const Side& side) {
    return side.x < frame.plot.left || side.x > frame.plot.right;
  });
  for (Side& side : sides) {
    side.top = std::max(side.top, frame.plot.top);
    side.bottom = std::min(side.bottom, frame.plot.bottom);
  }
  return sides;
}

/// Where a name fits best into a part of an area.
std::optional<NamePlace> place_of_name(const std::string& name, const std::vector<Area::Edge>& part,
                                       const Chart& chart, const Frame& frame) {
  const double half = text_width(name, name_size) / 2.0 + name_room;
  const std::vector<Side> sides = sides_of(part, chart, frame);
  std::optional<NamePlace> best;
  for (const Side& side : sides) {
    const double middle = (side.top + side.bottom) / 2;
    double room = std::min(side.x - half - sides.front().x, sides.back().x - half - side.x);
    for (const Side& other : sides) {
      if (std::abs(other.x - side.x) > half) continue;
      room = std::min(
          {room, middle - name_size / 2.0 - other.top, other.bottom - middle - name_size / 2.0});
    }
    if (room > 0 && (!best || room > best->room)) best = NamePlace{{side.x, middle + 4}, room};
  }
  return best;
}

}  // namespace

void paint_areas(const Chart& chart, const Frame& frame, const std::string& clip,
                 Drawing& drawing) {
  for (const Area& area : chart.areas) {
    std::vector<Outline> outlines;
    for (const auto& part : area.parts) outlines.push_back(outline_of_part(part, chart, frame));
    Brush brush = brush_of_area(area, drawing);
    brush.clip = clip;
    drawing.paint(brush, outlines);
  }
}

void write_names_of_areas(const Chart& chart, const Frame& frame, Drawing& drawing) {
  for (const Area& area : chart.areas) {
    if (area.name.empty()) continue;
    std::optional<NamePlace> best;
    for (const auto& part : area.parts) {
      const auto place = place_of_name(area.name, part, chart, frame);
      if (place && (!best || place->room > best->room)) best = place;
    }
    if (!best) continue;
    const bool dark = area.shade && *area.shade < 0.25;
    drawing.write({.colour = dark ? "#ffffff" : "#222222", .anchor = "middle", .size = name_size},
                  {{best->place, area.name}});
  }
}

void paint_key_of(const Area& area, const Pixel& from, Drawing& drawing) {
  const Outline key{{{from.x, from.y - 5},
                     {from.x + key_width, from.y - 5},
                     {from.x + key_width, from.y + 5},
                     {from.x, from.y + 5}},
                    true};
  drawing.paint(brush_of_area(area, drawing), {key});
  drawing.paint({.stroke = "#888888", .width = "0.7"}, {key});
}

}  // namespace ricochet::report
