#include "src/report/painted.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "src/report/text.h"

namespace ricochet::report {

namespace {

constexpr int name_size = 12;    // pixels
constexpr double name_step = 4;  // between places that are tried, pixels
constexpr double name_room = 2;  // on each side of a name

Outline rectangle(const Box& box) {
  return {
      {{box.left, box.bottom}, {box.right, box.bottom}, {box.right, box.top}, {box.left, box.top}},
      true};
}

/// Of the legend.
Outline key_at(const Pixel& from) {
  return rectangle({from.x, from.x + key_width, from.y - 5, from.y + 5});
}

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
  const Outline key = key_at(from);
  drawing.paint(brush_of_area(area, drawing), {key});
  drawing.paint({.stroke = "#888888", .width = "0.7"}, {key});
}

namespace {

constexpr int number_size = 10;  // pixels

/// Decimals that give the largest value three digits; 0 for whole numbers.
int decimals_of(const std::vector<double>& values) {
  if (std::ranges::all_of(values, [](double v) { return v == std::round(v); })) return 0;
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return std::clamp(2 - static_cast<int>(std::floor(std::log10(largest))), 0, 4);
}

class Cells {
 public:
  Cells(const HeatMap& map, const Frame& frame, Drawing& drawing)
      : map_(map), frame_(frame), drawing_(drawing) {
    for (const auto& row : map.rows)
      for (const auto& cell : row)
        if (cell) values_.push_back(*cell);
  }

  void paint() {
    paint_values();
    paint_gaps();
    write_values();
    paint_bar();
    if (values_.empty()) {
      drawing_.write({.colour = "#666666", .anchor = "middle"}, {{middle(frame_.plot), "no data"}});
    }
  }

 private:
  static Pixel middle(const Box& box) {
    return {(box.left + box.right) / 2, (box.top + box.bottom) / 2 + 4};
  }

  double share_of(double value) const { return share(value, frame_.colours, Scale::linear); }

  std::string colour_of(double value) const {
    return palette_colour(share_of(value), frame_.colours.lower < 0 && frame_.colours.upper > 0);
  }

  /// Edges are on whole pixels, so that neighbours leave no gap. Row 0 is the lowest.
  Box box(std::size_t row, std::size_t from, std::size_t to) const {
    const Box& plot = frame_.plot;
    const double columns = static_cast<double>(map_.rows.front().size());
    const double rows = static_cast<double>(map_.rows.size());
    const auto x = [&](std::size_t i) {
      return std::clamp(std::round(plot.left + plot.width() * static_cast<double>(i) / columns),
                        plot.left, plot.right);
    };
    const auto y = [&](std::size_t i) {
      return std::clamp(std::round(plot.bottom - plot.height() * static_cast<double>(i) / rows),
                        plot.top, plot.bottom);
    };
    return {x(from), x(to), y(row + 1), y(row)};
  }

  /// Neighbours of the same colour are merged into one rectangle.
  void paint_values() {
    std::map<std::string, std::vector<Outline>> painted;
    for (std::size_t row = map_.rows.size(); row-- > 0;) {
      const auto& cells = map_.rows[row];
      std::string last;
      std::size_t from = 0;
      for (std::size_t column = 0; column <= cells.size(); ++column) {
        const bool known = column < cells.size() && cells[column];
        const std::string colour = known ? colour_of(*cells[column]) : "";
        if (colour == last) continue;
        if (!last.empty()) painted[last].push_back(rectangle(box(row, from, column)));
        last = colour;
        from = column;
      }
    }
    for (const auto& [colour, outlines] : painted)
      drawing_.paint({.fill = colour, .crisp = true}, outlines);
  }

  void paint_gaps() {
    std::vector<Outline> outlines;
    for (std::size_t row = map_.rows.size(); row-- > 0;)
      for (std::size_t column = 0; column < map_.rows[row].size(); ++column)
        if (!map_.rows[row][column]) outlines.push_back(rectangle(box(row, column, column + 1)));
    if (outlines.empty()) return;
    drawing_.paint({.stroke = "#9a9a9a", .fill = drawing_.hatching()}, outlines);
  }

  void write_values() {
    const Box cell = box(0, 0, 1);
    const int decimals = values_.empty() ? 0 : decimals_of(values_);
    std::map<std::string, std::vector<Writing>> writings;
    for (std::size_t row = map_.rows.size(); row-- > 0;) {
      for (std::size_t column = 0; column < map_.rows[row].size(); ++column) {
        const auto& value = map_.rows[row][column];
        if (!value) continue;
        std::string text = fmt::format("{:.{}f}", std::abs(*value), decimals);
        const bool zero = text.find_first_not_of("0.") == std::string::npos;
        if (*value < 0 && !zero) text.insert(0, "−");
        // All values or none.
        if (text_width(text, number_size) + 4 > cell.width() || cell.height() < 12) return;
        writings[text_colour(colour_of(*value))].push_back(
            {middle(box(row, column, column + 1)), text});
      }
    }
    for (const auto& [colour, texts] : writings)
      drawing_.write({.colour = colour, .anchor = "middle", .size = number_size}, texts);
  }

  void paint_bar() {
    const Box& plot = frame_.plot;
    const Box bar{plot.right + bar_gap, plot.right + bar_gap + bar_width, plot.top, plot.bottom};
    const auto [lower, upper] = frame_.colours;
    std::vector<std::string> colours;
    for (int i = 0; i <= 10; ++i) colours.push_back(colour_of(lower + (upper - lower) * i / 10));
    drawing_.paint({.fill = drawing_.gradient(colours)}, {rectangle(bar)});
    std::vector<Outline> ticks = {rectangle(bar)};
    std::vector<Writing> labels;
    for (const Tick& tick : frame_.colour_ticks) {
      const double y = bar.bottom - bar.height() * share_of(tick.position);
      ticks.push_back({{{bar.right, y}, {bar.right + 4.5, y}}});
      labels.push_back({{bar.right + 9, y + 4}, tick.label});
    }
    drawing_.paint({.stroke = "#888888"}, ticks);
    drawing_.write({.colour = "#444444"}, labels);
  }

  const HeatMap& map_;
  const Frame& frame_;
  Drawing& drawing_;
  std::vector<double> values_;
};

}  // namespace

void paint_cells(const HeatMap& map, const Frame& frame, Drawing& drawing) {
  Cells(map, frame, drawing).paint();
}

void paint_key_of_gaps(const Pixel& from, Drawing& drawing) {
  drawing.paint({.stroke = "#9a9a9a", .fill = drawing.hatching()}, {key_at(from)});
}

SeriesLook look_of(const Chart& chart, std::size_t series) {
  static constexpr std::array colours{"#0072b2", "#d55e00", "#00a56a", "#7b2475",
                                      "#dd6ba0", "#6b4f00", "#606060"};
  static constexpr std::array dashes{"", "8.5,3.4", "1.7,2.5"};
  // Filled and open markers alternate, so that both are visible if two coincide.
  static constexpr std::array markers{
      Marker{0, true},  Marker{4, false}, Marker{3, true},  Marker{5, false}, Marker{4, true},
      Marker{0, false}, Marker{6, true},  Marker{3, false}, Marker{5, true},  Marker{6, false}};
  if (chart.series[series].pale) return {"#9a9a9a", "", {0, true}};
  std::size_t n = series;
  for (std::size_t i = 0; i < series && !chart.series[series].dark; ++i) n -= chart.series[i].pale;
  return {chart.series[series].dark ? "#1a1a1a" : colours[n % colours.size()],
          dashes[n % dashes.size()], markers[n % markers.size()]};
}

Outline outline_of(const Marker& marker, const Pixel& place, double radius) {
  if (marker.corners == 0) return {{place}, true, radius};
  Outline outline{{}, true};
  const double size = 1.25 * radius;  // about the same area as the circle
  for (int i = 0; i < marker.corners; ++i) {
    const double turn = 2 * std::numbers::pi * i / marker.corners;
    outline.corners.push_back({place.x + size * std::sin(turn), place.y - size * std::cos(turn)});
  }
  return outline;
}

LineLook line_look(std::size_t n) {
  static const std::array looks{LineLook{"#222222", "4.9,2.8", "1.4"},
                                LineLook{"#bf8600", "", "3.5"}, LineLook{"#7b3294", "1.5,3", "2"}};
  return looks[n % looks.size()];
}

namespace {

using Colour = std::array<int, 3>;  // red, green and blue, 0 to 255

// Even steps of lightness, so that it also reads in grey.
constexpr Colour rising[] = {{0x2b, 0x1c, 0x5e}, {0x2f, 0x4f, 0x8f}, {0x24, 0x80, 0x8c},
                             {0x3f, 0xae, 0x77}, {0xa5, 0xcf, 0x4c}, {0xf7, 0xe8, 0x5c}};

// Even steps in CIELAB on both sides of the middle, from lightness 42 to 97.
constexpr Colour two_sided[] = {{0x00, 0x68, 0xa3}, {0x5d, 0x89, 0xb8}, {0x93, 0xac, 0xcd},
                                {0xc5, 0xd1, 0xe2}, {0xf7, 0xf7, 0xf7}, {0xeb, 0xc9, 0xb7},
                                {0xd9, 0x9d, 0x7b}, {0xc2, 0x71, 0x41}, {0xa6, 0x46, 0x00}};

}  // namespace

std::string palette_colour(double share, bool diverging) {
  const std::span<const Colour> colours = diverging ? std::span<const Colour>(two_sided) : rising;
  const double step = std::round(100 * std::clamp(share, 0.0, 1.0)) / 100;
  const double place = step * static_cast<double>(colours.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), colours.size() - 2);
  std::string text = "#";
  for (std::size_t i = 0; i < 3; ++i) {
    const int from = colours[below][i], to = colours[below + 1][i];
    text += fmt::format("{:02x}",
                        from + std::lround((to - from) * (place - static_cast<double>(below))));
  }
  return text;
}

std::string text_colour(const std::string& colour) {
  double luminance = 0;  // as WCAG 2.2 defines it
  for (const auto& [from, weight] :
       {std::pair<std::size_t, double>{1, 0.2126}, {3, 0.7152}, {5, 0.0722}}) {
    const double part = std::stoi(colour.substr(from, 2), nullptr, 16) / 255.0;
    luminance += weight * (part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4));
  }
  return luminance < 0.179 ? "#ffffff" : "#000000";  // where both have the same contrast
}

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
