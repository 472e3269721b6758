#include "src/report/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>

#include "src/report/drawing.h"
#include "src/report/frame.h"
#include "src/report/painted.h"

namespace ricochet::report {

namespace {

constexpr double marker_radius = 3.6, small_radius = 1.8;  // pixels

class Painter {
 public:
  Painter(const Chart& chart, const Frame& frame)
      : chart_(chart),
        frame_(frame),
        drawing_(chart.name, chart.title, description(chart), frame.width, frame.height) {
    if (!chart.heat_map) clip_ = drawing_.clip(frame.plot);
    for (const Series& series : chart.series) {
      has_names_ |= std::ranges::any_of(series.samples,
                                        [](const Sample& sample) { return !sample.name.empty(); });
    }
  }

  std::string svg() {
    drawing_.write({.size = title_size, .bold = true},
                   lines_of(frame_.title, {8, 24}, title_height));
    paint_axes();
    if (chart_.heat_map) {
      paint_cells(*chart_.heat_map, frame_, drawing_);
    } else {
      paint_areas(chart_, frame_, clip_, drawing_);
      has_values_ |= !chart_.areas.empty();
      paint_lines();
      for (std::size_t i = 0; i < chart_.series.size(); ++i) paint_spread(i);
      for (std::size_t i = 0; i < chart_.series.size(); ++i) paint_series(i);
      if (!has_values_) write_no_data();
    }
    write_names();
    write_names_of_areas(chart_, frame_, drawing_);
    write_ends();
    for (const LegendEntry& entry : frame_.legend) write_entry(entry);
    return drawing_.text();
  }

 private:
  Pixel place(double position, double value) const {
    return place_of(chart_, frame_, position, value);
  }
  Pixel place(const Sample& sample) const { return place(sample.position, *sample.value); }

  static Brush brush_of(const SeriesLook& look) {
    return {.stroke = look.colour, .width = "1.7", .dash = look.dash};
  }
  static Brush brush_of(const LineLook& look) {
    return {.stroke = look.colour, .width = look.width, .dash = look.dash};
  }

  void paint_axes() {
    const Box& plot = frame_.plot;
    std::vector<Outline> grid, ticks;
    std::vector<Writing> x_labels, x_above, y_labels;
    const bool names = !chart_.x.categories.empty();
    for (const Tick& tick : frame_.x_ticks) {
      const double x = place(tick.position, frame_.y.lower).x;
      if (!names) ticks.push_back({{{x, plot.bottom + length(tick)}, {x, plot.bottom}}});
      if (tick.label.empty()) continue;
      grid.push_back({{{x, plot.bottom}, {x, plot.top}}});
      x_labels.push_back({{x, plot.bottom + (frame_.names_turned ? 12 : 17)}, tick.label});
      if (frame_.names_above) x_above.push_back({{x, plot.top - 6}, tick.label});
    }
    for (const Tick& tick : frame_.y_ticks) {
      const double y = place(frame_.x.lower, tick.position).y;
      ticks.push_back({{{plot.left - length(tick), y}, {plot.left, y}}});
      if (tick.label.empty()) continue;
      grid.push_back({{{plot.left, y}, {plot.right, y}}});
      y_labels.push_back({{plot.left - 9, y + 4}, tick.label});
    }
    if (!chart_.heat_map) {
      ticks.push_back(
          {{{plot.left, plot.top}, {plot.left, plot.bottom}, {plot.right, plot.bottom}}});
      drawing_.paint({.stroke = "#e4e4e4", .width = "0.7"}, grid);
      drawing_.paint({.stroke = "#888888"}, ticks);
    }
    for (const auto& [labels, angle] : {std::pair{x_labels, -name_angle}, {x_above, name_angle}}) {
      drawing_.write({.colour = "#444444",
                      .anchor = frame_.names_turned ? "end" : "middle",
                      .turned = frame_.names_turned ? static_cast<double>(angle) : 0.0},
                     labels);
    }
    drawing_.write({.colour = "#444444", .anchor = "end"}, y_labels);
    for (const AxisLabel& label : frame_.labels) {
      drawing_.write({.anchor = "middle", .turned = label.upright ? 270.0 : 0.0},
                     lines_of(label.lines, label.place, line_height, label.upright));
    }
  }

  static std::vector<Writing> lines_of(const std::vector<std::string>& lines, Pixel place,
                                       double distance, bool upright = false) {
    std::vector<Writing> writings;
    for (const std::string& line : lines) {
      writings.push_back({place, line});
      (upright ? place.x : place.y) += distance;
    }
    return writings;
  }

  static double length(const Tick& tick) { return tick.label.empty() ? 2.7 : 4.5; }

  void paint_lines() {
    const std::vector<std::string> labels = line_labels(chart_);
    // The last label is drawn first, so that the first lies on top.
    for (std::size_t i = labels.size(); i-- > 0;) {
      std::vector<Outline> outlines;
      for (const ReferenceLine& line : chart_.lines) {
        if (line.label != labels[i]) continue;
        const bool vertical = line.direction == Direction::vertical;
        const double at = line.position;
        outlines.push_back(
            {vertical ? std::vector{place(at, frame_.y.lower), place(at, frame_.y.upper)}
                      : std::vector{place(frame_.x.lower, at), place(frame_.x.upper, at)}});
      }
      drawing_.paint(clipped(brush_of(line_look(i))), outlines);
    }
  }

  Brush clipped(Brush brush) const {
    brush.clip = clip_;
    return brush;
  }

  void paint_spread(std::size_t index) {
    const Series& series = chart_.series[index];
    const std::string colour = look_of(chart_, index).colour;
    std::vector<Outline> outlines;
    if (series.mark == Mark::points) {
      for (const bool pale : {true, false}) {
        drawing_.paint(
            {.stroke = pale ? "#d4d4d4" : colour, .width = pale ? "0.5" : "1.2", .clip = clip_},
            bars(series, pale));
      }
      return;
    }
    for (const std::vector<Sample>& part : polylines(series)) {
      // A band ends where the spread is unknown.
      for (auto from = part.begin(); from != part.end();) {
        from = std::find_if(from, part.end(), [](const Sample& s) { return s.spread; });
        const auto to = std::find_if(from, part.end(), [](const Sample& s) { return !s.spread; });
        if (to - from > 1) outlines.push_back(band({from, to}));
        from = to;
      }
    }
    drawing_.paint({.fill = colour, .opacity = "0.14", .clip = clip_}, outlines);
  }

  /// The spreads of points: pale are those of a pale series, and where others have names those of
  /// points without one.
  std::vector<Outline> bars(const Series& series, bool pale) const {
    std::vector<Outline> outlines;
    for (const Sample& sample : series.samples) {
      const bool is_pale = series.pale || (has_names_ && sample.name.empty());
      if (!sample.value || !sample.spread || is_pale != pale) continue;
      outlines.push_back({{place(sample.position, sample.spread->lower),
                           place(sample.position, sample.spread->upper)}});
    }
    return outlines;
  }

  Outline band(const std::vector<Sample>& samples) const {
    Outline area{{}, true};
    for (const Sample& sample : samples)
      area.corners.push_back(place(sample.position, sample.spread->lower));
    for (auto sample = samples.rbegin(); sample != samples.rend(); ++sample)
      area.corners.push_back(place(sample->position, sample->spread->upper));
    return area;
  }

  void paint_series(std::size_t index) {
    const Series& series = chart_.series[index];
    const SeriesLook look = look_of(chart_, index);
    std::vector<Pixel> dots;
    std::vector<Outline> lines;
    if (series.mark == Mark::points) {
      for (const Sample& sample : series.samples)
        if (sample.value) dots.push_back(place(sample));
    } else {
      for (const std::vector<Sample>& part : polylines(series)) {
        std::vector<Pixel> line;
        for (const Sample& sample : part) line.push_back(place(sample));
        // A line of a single sample has no length and would be invisible.
        if (line.size() == 1) {
          dots.push_back(line.front());
        } else {
          lines.push_back({std::move(line)});
        }
      }
    }
    has_values_ |= !dots.empty() || !lines.empty();
    std::erase_if(dots, [&](const Pixel& dot) { return !frame_.plot.holds(dot); });
    drawing_.paint(clipped(brush_of(look)), lines);
    paint_dots(look, dots, series.mark == Mark::points ? marker_radius : small_radius);
  }

  void paint_dots(const SeriesLook& look, const std::vector<Pixel>& dots, double radius) {
    std::vector<Outline> outlines;
    if (look.marker.filled && look.marker.corners == 0) {
      // A dot of a broad round pen is the shortest way to write a circle.
      for (const Pixel& dot : dots) outlines.push_back({{dot}});
      const char* const across = radius == marker_radius ? "7.2" : "3.6";
      drawing_.paint({.stroke = look.colour, .width = across, .cap = "round"}, outlines);
      return;
    }
    for (const Pixel& dot : dots) outlines.push_back(outline_of(look.marker, dot, radius));
    if (look.marker.filled) {
      drawing_.paint({.fill = look.colour}, outlines);
    } else {
      drawing_.paint({.stroke = look.colour, .width = "1.2"}, outlines);
    }
  }

  void write_no_data() {
    const Box& plot = frame_.plot;
    drawing_.write({.colour = "#666666", .anchor = "middle"},
                   {{{(plot.left + plot.right) / 2, (plot.top + plot.bottom) / 2}, "no data"}});
  }

  void write_names() {
    const std::vector<PointName> names = names_of_points(chart_, frame_);
    std::vector<Outline> leaders;
    for (const PointName& name : names)
      if (name.led) leaders.push_back({{name.dot, name.place}});
    drawing_.paint({.stroke = "#888888", .width = "0.6"}, leaders);
    for (const bool pale : {false, true}) {
      for (const bool left : {false, true}) {
        std::vector<Writing> writings;
        for (const PointName& name : names) {
          if (name.pale != pale || name.to_the_left != left) continue;
          writings.push_back({{name.place.x, name.place.y + 3.5}, name.text});
        }
        drawing_.write(
            {.colour = pale ? "#8a8a8a" : "black", .anchor = left ? "end" : "start", .size = 10},
            writings);
      }
    }
  }

  void write_ends() {
    const Box& plot = frame_.plot;
    const bool led = need_leaders(frame_.ends, plot.height());
    const double x = plot.right + 6 + (led ? leader_width : 0);
    std::vector<Writing> writings;
    for (const EndLabel& label : frame_.ends) {
      const double y = plot.bottom - label.place * plot.height();
      writings.push_back({{x, y + 4}, label.text});
      if (!led) continue;
      const Pixel end{plot.right + 2, plot.bottom - label.end * plot.height()};
      drawing_.paint({.stroke = look_of(chart_, label.series).colour}, {{{end, {x - 3, y}}}});
    }
    drawing_.write({}, writings);
  }

  void write_entry(const LegendEntry& entry) {
    const Pixel from{entry.place.x, entry.place.y - 4}, to{from.x + key_width, from.y};
    const Pixel middle{(from.x + to.x) / 2, from.y};
    if (entry.of == LegendEntry::Of::cells_without_value) {
      paint_key_of_gaps(from, drawing_);
    } else if (entry.of == LegendEntry::Of::area) {
      paint_key_of(chart_.areas[entry.numbers.front()], from, drawing_);
    } else if (entry.of == LegendEntry::Of::line) {
      drawing_.paint(brush_of(line_look(entry.numbers.front())), {{{from, to}}});
    } else {
      for (const std::size_t number : entry.numbers) {
        if (chart_.series[number].mark == Mark::points) {
          paint_dots(look_of(chart_, number), {middle}, marker_radius);
        } else {
          drawing_.paint(brush_of(look_of(chart_, number)), {{{from, to}}});
        }
      }
    }
    drawing_.write({}, lines_of(entry.lines, {to.x + 6, entry.place.y}, line_height));
  }

  const Chart& chart_;
  const Frame& frame_;
  Drawing drawing_;
  std::string clip_;
  bool has_values_ = false;
  bool has_names_ = false;  ///< of some points
};

}  // namespace

std::string to_svg(const Chart& chart) {
  check(chart);
  const Frame frame = frame_of(chart);
  return Painter(chart, frame).svg();
}

std::vector<std::vector<Sample>> polylines(const Series& series) {
  std::vector<std::vector<Sample>> parts;
  bool joined = false;
  for (const Sample& sample : series.samples) {
    if (joined && series.mark == Mark::steps) {
      // The last value holds up to here, even if the value is unknown from here on.
      const Sample last = parts.back().back();
      parts.back().push_back({sample.position, last.value, last.spread});
    }
    if (!sample.value) {
      joined = false;
      continue;
    }
    if (!joined) parts.emplace_back();
    parts.back().push_back(sample);
    joined = true;
  }
  return parts;
}

namespace {

std::string text_of(long tenths) {
  const long size = std::labs(tenths);
  std::string text = tenths < 0 ? "-" : "";
  if (size >= 10 || size == 0) text += std::to_string(size / 10);
  if (size % 10 != 0) text += fmt::format(".{}", size % 10);
  return text;
}

long whole_tenths(double pixels) {
  return std::lround(10 * pixels);
}

/// Writes path data and keeps the current position.
class Pen {
 public:
  void move(const Pixel& to) { go('M', 'm', to); }

  void draw(const Pixel& to) {
    const long across = whole_tenths(to.x) - x_, down = whole_tenths(to.y) - y_;
    if (across == 0 && down == 0) return;
    if (down == 0) {
      write('h', {across});
    } else if (across == 0) {
      write('v', {down});
    } else {
      write('l', {across, down});
    }
    x_ += across;
    y_ += down;
  }

  void dot() { write('h', {0}); }

  void circle(double radius) {
    const long r = whole_tenths(radius);
    write('m', {-r, 0});
    write('a', {r, r, 0, 10, 0, 2 * r, 0});
    write('a', {r, r, 0, 10, 0, -2 * r, 0});
    text_ += 'z';
    last_ = 'z';
    x_ -= r;
  }

  /// Back to where the outline began.
  void close(const Pixel& start) {
    text_ += 'z';
    last_ = 'z';
    x_ = whole_tenths(start.x);
    y_ = whole_tenths(start.y);
  }

  const std::string& text() const { return text_; }

 private:
  void go(char absolute, char relative, const Pixel& to) {
    const long x = whole_tenths(to.x), y = whole_tenths(to.y);
    if (text_.empty()) {
      write(absolute, {x, y});
    } else {
      write(relative, {x - x_, y - y_});
    }
    x_ = x;
    y_ = y;
  }

  /// Omits a repeated command, and a space before a sign or a decimal point.
  void write(char command, std::initializer_list<long> numbers) {
    bool after_a_number = command == last_ && command != 'M' && command != 'm';
    if (!after_a_number) text_ += command;
    last_ = command;
    for (const long number : numbers) {
      const std::string text = text_of(number);
      const bool parts = text[0] == '-' || (text[0] == '.' && ends_in_a_fraction_);
      if (after_a_number && !parts) text_ += ' ';
      text_ += text;
      ends_in_a_fraction_ = number % 10 != 0;
      after_a_number = true;
    }
  }

  std::string text_;
  char last_ = ' ';
  bool ends_in_a_fraction_ = false;
  long x_ = 0, y_ = 0;
};

std::vector<Pixel> needed(const Outline& outline) {
  std::vector<Pixel> corners;
  for (const std::size_t i : needed_corners(outline.corners, 0.1))
    corners.push_back(outline.corners[i]);
  return corners;
}

/// The coordinates of an outline in the order in which it is written.
std::vector<long> places_of(const std::vector<Pixel>& corners, const Outline& outline) {
  std::vector<long> places = {outline.closed ? 1 : 0, whole_tenths(outline.radius)};
  for (const Pixel& corner : corners) {
    places.insert(places.end(), {whole_tenths(corner.x), whole_tenths(corner.y)});
  }
  return places;
}

}  // namespace

std::string path_data(const std::vector<Outline>& outlines) {
  Pen pen;
  std::set<std::vector<long>> drawn;
  for (const Outline& outline : outlines) {
    const std::vector<Pixel> corners = needed(outline);
    if (corners.empty() || !drawn.insert(places_of(corners, outline)).second) continue;
    pen.move(corners.front());
    if (outline.radius > 0) {
      pen.circle(outline.radius);
      continue;
    }
    if (corners.size() == 1) pen.dot();
    for (std::size_t i = 1; i < corners.size(); ++i) pen.draw(corners[i]);
    if (outline.closed) pen.close(corners.front());
  }
  return pen.text();
}

}  // namespace ricochet::report
