#include "src/report/painted_areas.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "src/report/look.h"
#include "src/report/wrapped.h"

namespace ricochet::report {
namespace {

constexpr int name_size = 12;    // pixels
constexpr double name_room = 5;  // on each side of a name

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

/// Where a name fits best into a part: where that is highest, off its ends.
std::optional<Pixel> place_of_name(const std::string& name, const std::vector<Area::Edge>& part,
                                   const Chart& chart, const Frame& frame) {
  const double half = text_width(name, name_size) / 2.0 + name_room;
  const Box& plot = frame.plot;
  const auto x_of = [&](const Area::Edge& edge) {
    return place_of(chart, frame, edge.position, edge.between.lower).x;
  };
  const double from = std::max(plot.left, x_of(part.front()));
  const double to = std::min(plot.right, x_of(part.back()));
  double highest = name_size + 2 * name_room;
  std::optional<Pixel> best;
  for (const Area::Edge& edge : part) {
    const double x = x_of(edge);
    if (x - half < from || x + half > to) continue;
    const Pixel low = place_of(chart, frame, edge.position, edge.between.lower);
    const Pixel high = place_of(chart, frame, edge.position, edge.between.upper);
    const double bottom = std::min(low.y, plot.bottom), top = std::max(high.y, plot.top);
    if (bottom - top > highest) {
      highest = bottom - top;
      best = Pixel{x, (bottom + top) / 2 + 4};
    }
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
    std::vector<Writing> writings;
    for (const auto& part : area.parts) {
      if (const auto place = place_of_name(area.name, part, chart, frame)) {
        writings.push_back({*place, area.name});
      }
    }
    const bool dark = area.shade && *area.shade < 0.25;
    drawing.write({.colour = dark ? "#ffffff" : "#222222", .anchor = "middle", .size = name_size},
                  writings);
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
