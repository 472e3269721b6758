#include "src/report/painted_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "src/report/look.h"
#include "src/report/wrapped.h"

namespace ricochet::report {
namespace {

constexpr int number_size = 10;  // pixels

Outline rectangle(const Box& box) {
  return {
      {{box.left, box.bottom}, {box.right, box.bottom}, {box.right, box.top}, {box.left, box.top}},
      true};
}

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
        const std::string colour = known ? palette_colour(share_of(*cells[column])) : "";
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
        const std::string text = fmt::format("{:.{}f}", *value, decimals);
        // All values or none.
        if (text_width(text, number_size) + 4 > cell.width() || cell.height() < 12) return;
        writings[text_colour(share_of(*value))].push_back(
            {middle(box(row, column, column + 1)), text});
      }
    }
    for (const auto& [colour, texts] : writings)
      drawing_.write({.colour = colour, .anchor = "middle", .size = number_size}, texts);
  }

  void paint_bar() {
    const Box& plot = frame_.plot;
    const Box bar{plot.right + bar_gap, plot.right + bar_gap + bar_width, plot.top, plot.bottom};
    std::vector<std::string> colours;
    for (const double place : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0})
      colours.push_back(palette_colour(place));
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
  const Box key{from.x, from.x + key_width, from.y - 5, from.y + 5};
  drawing.paint({.stroke = "#9a9a9a", .fill = drawing.hatching()}, {rectangle(key)});
}

}  // namespace ricochet::report
