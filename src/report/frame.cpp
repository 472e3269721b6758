#include "src/report/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "src/report/painted.h"
#include "src/report/text.h"

namespace ricochet::report {

namespace {

constexpr double least_width = 60, least_height = 30;  // of the plot, pixels
constexpr double text_height = 18;                     // of a line with the gap above it
constexpr double tick_room = 9;                        // a tick and the gap up to its label
constexpr double row_height = 13;                      // least, of names of y
constexpr double edge = 4;                             // least gap up to the picture's edge
constexpr double bold_size = 1.14 * title_size;        // of a plain text that is as wide
constexpr double widest_side =
    0.45;  // of the chart's size, beside the plot before the picture grows
constexpr double longest_name = 420, longest_entry = 220;  // of a tick, of a line in the legend
constexpr std::size_t rows_without_names_above = 20;       // of a heat map
const double sine = std::sin(name_angle * std::numbers::pi / 180);
const double cosine = std::cos(name_angle * std::numbers::pi / 180);

double widest(const std::vector<Tick>& ticks) {
  double width = 0;
  for (const Tick& tick : ticks) width = std::max(width, text_width(tick.label));
  return width;
}

/// About as many ticks as wanted, of positions or of values.
std::vector<Tick> number_ticks(const Chart& chart, bool positions, const Range& range,
                               double wanted) {
  const int number = std::max(2, static_cast<int>(wanted));
  if ((positions ? chart.x : chart.y).scale == Scale::logarithmic)
    return logarithmic_ticks(range, number);
  const bool whole =
      !chart.series.empty() && std::ranges::all_of(chart.series, [&](const Series& series) {
        return std::ranges::all_of(series.samples, [&](const Sample& sample) {
          const double value = positions ? sample.position : sample.value.value_or(0);
          return value == std::round(value);
        });
      });
  return linear_ticks(range, number, whole);
}

Range data_limits(const Chart& chart, Direction of_lines) {
  const bool positions = of_lines == Direction::vertical;
  const Axis& axis = positions ? chart.x : chart.y;
  if (axis.range) return *axis.range;
  if (!axis.categories.empty()) return {-0.5, static_cast<double>(axis.categories.size()) - 0.5};
  std::vector<double> values;
  for (const ReferenceLine& line : chart.lines)
    if (line.direction == of_lines) values.push_back(line.position);
  for (const Series& series : chart.series) {
    for (const Sample& sample : series.samples) {
      if (positions) values.push_back(sample.position);
      if (!positions && sample.value) values.push_back(*sample.value);
      if (!positions && sample.value && sample.spread)
        values.insert(values.end(), {sample.spread->lower, sample.spread->upper});
    }
  }
  for (const Area& area : chart.areas) {
    for (const auto& part : area.parts) {
      for (const Area::Edge& edge : part) {
        if (positions) values.push_back(edge.position);
        if (!positions) values.insert(values.end(), {edge.between.lower, edge.between.upper});
      }
    }
  }
  return limits(values, axis.scale);
}

Range colour_limits(const HeatMap& map) {
  std::vector<double> values;
  for (const auto& row : map.rows)
    for (const auto& cell : row)
      if (cell) values.push_back(*cell);
  Range colours = map.range.value_or(Range{0, 1});
  if (!map.range && !values.empty()) {
    const auto [least, most] = std::ranges::minmax(values);
    colours = {least, most};
  }
  if (colours.lower < 0 && colours.upper > 0) {
    const double farthest = std::max(-colours.lower, colours.upper);
    return {-farthest, farthest};
  }
  return colours.lower < colours.upper ? colours : limits({colours.lower}, Scale::linear);
}

bool has_gaps(const HeatMap& map) {
  return std::ranges::any_of(map.rows, [](const auto& row) {
    return std::ranges::any_of(row, [](const auto& cell) { return !cell; });
  });
}

/// Returns the names of an axis that fit, each `needed` pixels wide.
std::vector<Tick> name_ticks(const std::vector<std::string>& names, double room, double needed) {
  const double slot = room / static_cast<double>(names.size());
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::ceil(needed / slot)));
  std::vector<Tick> ticks;
  for (std::size_t i = 0; i < names.size(); i += stride)
    ticks.push_back({static_cast<double>(i), shortened(names[i], longest_name)});
  return ticks;
}

bool is_seen(const Area& area, const Frame& frame) {
  const auto meet = [](const Range& a, const Range& b) {
    return a.lower <= b.upper && b.lower <= a.upper;
  };
  return std::ranges::any_of(area.parts, [&](const std::vector<Area::Edge>& part) {
    return meet({part.front().position, part.back().position}, frame.x) &&
           std::ranges::any_of(part, [&](const auto& e) { return meet(e.between, frame.y); });
  });
}

using Pixels = std::set<std::pair<long, long>>;

/// Where a series is drawn within the plot.
Pixels pixels_of(const Series& series, const Chart& chart, const Frame& frame) {
  Pixels drawn;
  for (const std::vector<Sample>& part : polylines(series)) {
    Pixel last = place_of(chart, frame, part.front().position, *part.front().value);
    for (const Sample& sample : part) {
      const Pixel next = place_of(chart, frame, sample.position, *sample.value);
      if (series.mark == Mark::points) last = next;
      const double steps = std::clamp(std::hypot(next.x - last.x, next.y - last.y), 1.0, 1e4);
      for (double step = 0; step <= steps; ++step) {
        const double share = step / steps;
        const Pixel at{last.x + share * (next.x - last.x), last.y + share * (next.y - last.y)};
        if (frame.plot.holds(at)) drawn.insert({std::lround(at.x), std::lround(at.y)});
      }
      last = next;
    }
  }
  return drawn;
}

/// Whether each pixel has one of the others at most two pixels to its side and two above or below:
/// lines are nearly as broad.
bool within(const Pixels& pixels, const Pixels& others) {
  return std::ranges::all_of(pixels, [&](const auto& pixel) {
    for (const long across : {0, -1, 1, -2, 2})
      for (const long down : {0, -1, 1, -2, 2})
        if (others.contains({pixel.first + across, pixel.second + down})) return true;
    return false;
  });
}

/// A frame of known limits and a plot of about its final size suffices.
std::vector<LegendEntry> legend_of(const Chart& chart, const Frame& frame) {
  using Of = LegendEntry::Of;
  std::vector<LegendEntry> legend;
  if (chart.heat_map) {
    if (has_gaps(*chart.heat_map)) legend.push_back({Of::cells_without_value, {0}, {"no value"}});
    return legend;
  }
  std::size_t labels = frame.ends.size();  // also of what is not seen
  const auto add = [&](Of of, std::size_t number, const std::string& label, bool seen) {
    labels += label.empty() ? 0 : 1;
    if (!label.empty() && seen) legend.push_back({of, {number}, {label}});
  };
  for (std::size_t i = 0; i < chart.areas.size(); ++i)
    add(Of::area, i, chart.areas[i].label, is_seen(chart.areas[i], frame));
  std::vector<std::pair<LegendEntry, Pixels>> drawn;  // with the pixels of the entry's last series
  for (std::size_t i = 0; i < chart.series.size() && frame.ends.empty(); ++i) {
    const Series& series = chart.series[i];
    if (series.label.empty()) continue;
    ++labels;
    Pixels own = pixels_of(series, chart, frame);
    if (own.empty()) continue;
    const bool points = series.mark == Mark::points;
    const SeriesLook look = look_of(chart, i);
    const bool covers = points ? look.marker.filled : look.dash.empty();
    const auto same = std::ranges::find_if(drawn, [&](const auto& other) {
      const bool other_points = chart.series[other.first.numbers.back()].mark == Mark::points;
      return points == other_points && within(other.second, own) &&
             (covers || within(own, other.second));
    });
    if (same == drawn.end()) {
      drawn.emplace_back(LegendEntry{Of::series, {i}, {series.label}}, std::move(own));
    } else {
      same->first.numbers.push_back(i);
      same->first.lines.front() += "; " + series.label;
      same->second = std::move(own);
    }
  }
  for (auto& [entry, pixels] : drawn) legend.push_back(std::move(entry));
  const std::vector<std::string> lines = line_labels(chart);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    add(Of::line, i, lines[i], std::ranges::any_of(chart.lines, [&](const ReferenceLine& line) {
          const Range& range = line.direction == Direction::vertical ? frame.x : frame.y;
          return line.label == lines[i] && range.lower <= line.position &&
                 line.position <= range.upper;
        }));
  }
  // A single entry needs no legend: title and axis name it.
  if (labels == 1) legend.clear();
  for (LegendEntry& entry : legend) entry.lines = wrapped(entry.lines.front(), longest_entry);
  return legend;
}

/// Places the parts of a frame one after the other; each part may depend only on earlier ones.
class Layout {
 public:
  explicit Layout(const Chart& chart) : chart_(chart) {}

  Frame frame() {
    frame_.title = wrapped(chart_.title, chart_.width - 16, bold_size);
    frame_.plot.top = 26 + title_height * static_cast<double>(frame_.title.size());
    frame_.x = data_limits(chart_, Direction::vertical);
    frame_.y = data_limits(chart_, Direction::horizontal);
    if (chart_.heat_map) frame_.colours = colour_limits(*chart_.heat_map);
    x_label_ = wrapped(chart_.x.label, chart_.width - 2 * edge);
    const double height = std::max(
        least_height, chart_.height - frame_.plot.top - text_height - label_height(x_label_) - 8);
    place_y_ticks(height);
    // The plot without a legend, which end labels replace.
    frame_.plot.right = std::max(frame_.plot.left + least_width, chart_.width - 18.0);
    frame_.plot.bottom = frame_.plot.top + height;
    frame_.ends = end_labels(chart_, frame_.x, frame_.y, height);
    frame_.legend = legend_of(chart_, frame_);
    legend_beside_ = frame_.legend.size() > 4;
    place_right_side(need_leaders(frame_.ends, height));
    place_x_ticks();
    make_room_for_x_ticks();
    place_bottom();
    if (legend_beside_) {
      double lines = 0;
      for (const LegendEntry& entry : frame_.legend)
        lines += static_cast<double>(entry.lines.size());
      const Pixel first{frame_.plot.right + 14, frame_.plot.top + 10};
      const double distance = std::clamp(frame_.plot.height() / lines, 14.0, 20.0);
      const double bottom = first.y + place_legend(first, distance) + 8;
      frame_.height = std::max(frame_.height, static_cast<int>(std::ceil(bottom)));
    }
    place_labels();
    return std::move(frame_);
  }

 private:
  static double label_height(const std::vector<std::string>& lines) {
    return lines.empty() ? 0 : 3 + line_height * static_cast<double>(lines.size());
  }
  /// What an upright label takes beside the ticks.
  static double label_width(const std::vector<std::string>& lines) {
    return lines.empty() ? 6 : 8 + label_height(lines);
  }

  void place_y_ticks(double height) {
    frame_.y_ticks = chart_.y.categories.empty()
                         ? number_ticks(chart_, false, frame_.y, height / 38)
                         : name_ticks(chart_.y.categories, height, row_height);
    const double room = chart_.height - frame_.plot.top;
    y_label_ = wrapped(chart_.y.label, room);
    frame_.plot.left = label_width(y_label_) + widest(frame_.y_ticks) + tick_room;
    if (!chart_.heat_map) return;
    frame_.colour_ticks =
        linear_ticks(frame_.colours, std::clamp(static_cast<int>(height / 25), 2, 6), false);
    colour_label_ = wrapped(chart_.heat_map->label, room);
  }

  void place_right_side(bool leaders) {
    double right = 18, text = 0;
    for (const EndLabel& end : frame_.ends) text = std::max(text, text_width(end.text));
    if (legend_beside_)
      for (const LegendEntry& entry : frame_.legend)
        text = std::max(text, report::widest(entry.lines));
    if (chart_.heat_map) {
      right = bar_gap + bar_width + tick_room + widest(frame_.colour_ticks) +
              label_width(colour_label_);
    } else if (!frame_.ends.empty()) {
      right = text + 14 + (leaders ? leader_width : 0);
    } else if (legend_beside_) {
      right = text + key_width + 28;
    }
    Box& plot = frame_.plot;
    const double most = widest_side * chart_.width;
    plot.right = plot.left + std::max(least_width, chart_.width - std::min(plot.left, most) -
                                                       std::min(right, most));
    frame_.width = static_cast<int>(
        std::ceil(std::max({plot.right + right, report::widest(frame_.title, bold_size) + 16,
                            report::widest(x_label_) + 2 * edge})));
  }

  void place_x_ticks() {
    const std::vector<std::string>& names = chart_.x.categories;
    if (names.empty()) {
      frame_.x_ticks = number_ticks(chart_, true, frame_.x, frame_.plot.width() / 65);
      return;
    }
    const double slot = frame_.plot.width() / static_cast<double>(names.size());
    const double needed = widest(name_ticks(names, 1e9, 0)) + 8;
    frame_.names_turned = needed > slot && needed > 50;
    frame_.x_ticks = name_ticks(names, frame_.plot.width(), frame_.names_turned ? 16 : needed);
  }

  /// Widens the picture where its first or last ticks would leave it.
  void make_room_for_x_ticks() {
    double before = 0, after = 0;
    for (const Tick& tick : frame_.x_ticks) {
      const double x = place_of(chart_, frame_, tick.position, frame_.y.lower).x;
      const double width = text_width(tick.label);
      before = std::max(before, edge - x + (frame_.names_turned ? cosine * width + 6 : width / 2));
      if (!frame_.names_turned) after = std::max(after, x + width / 2 + edge - frame_.width);
    }
    frame_.plot.left += std::ceil(before);
    frame_.plot.right += std::ceil(before);
    frame_.width += static_cast<int>(std::ceil(before) + std::ceil(after));
  }

  void place_bottom() {
    frame_.names_above = chart_.heat_map && !chart_.x.categories.empty() &&
                         chart_.y.categories.size() > rows_without_names_above;
    below_ = frame_.names_turned ? 14 + sine * widest(frame_.x_ticks) : text_height;
    const double above = frame_.names_above ? below_ : 0;
    frame_.plot.top += above;
    double below = below_ + label_height(x_label_);
    if (!frame_.legend.empty() && !legend_beside_) {
      below += edge + text_height;  // the plot's bottom is not known yet
      below += place_legend({frame_.plot.left, below}, text_height);
    }
    const double beside = std::min(below, widest_side * chart_.height);
    const double rows =
        chart_.y.categories.empty() ? 0 : static_cast<double>(frame_.y_ticks.size());
    const double least = std::max(least_height, row_height * rows);
    const double height = std::max(least, chart_.height + above - frame_.plot.top - beside - 8);
    frame_.plot.bottom = frame_.plot.top + std::floor(height);
    const double upright = std::max(report::widest(y_label_), report::widest(colour_label_));
    frame_.height = static_cast<int>(
        std::ceil(std::max(frame_.plot.bottom + below + 8, frame_.plot.top + upright + edge)));
    for (LegendEntry& entry : frame_.legend) entry.place.y += frame_.plot.bottom;
  }

  /// Places the legend's entries from the first place on, in rows that end with the picture, or
  /// beside the plot one below the other. Returns the distance down to the last line.
  double place_legend(const Pixel& first, double distance) {
    Pixel next = first;
    double more = 0;  // lines in this row
    for (LegendEntry& entry : frame_.legend) {
      const double width = key_width + 6 + report::widest(entry.lines);
      if (next.x > first.x && (legend_beside_ || next.x + width > frame_.width)) {
        next = {first.x, next.y + more + distance};
        more = 0;
      }
      entry.place = next;
      next.x += width + 18;
      more = std::max(more, label_height(entry.lines) - text_height);
      frame_.width = std::max(frame_.width, static_cast<int>(std::ceil(first.x + width + edge)));
    }
    return next.y + more - first.y;
  }

  /// In the middle of their axes, as far as they stay within the picture.
  void place_labels() {
    const Box& plot = frame_.plot;
    const auto add = [&](const std::vector<std::string>& lines, double along, double across) {
      if (lines.empty()) return;
      const bool upright = &lines != &x_label_;
      const double half = report::widest(lines) / 2 + edge;
      const double least = upright ? plot.top - 18 : 0,
                   most = upright ? frame_.height : frame_.width;
      const double middle = std::max(std::min(along, most - half), least + half);
      frame_.labels.push_back(
          {lines, upright ? Pixel{across, middle} : Pixel{middle, across}, upright});
    };
    const double middle = (plot.top + plot.bottom) / 2;
    add(x_label_, (plot.left + plot.right) / 2, plot.bottom + below_ + text_height);
    add(y_label_, middle,
        plot.left - tick_room - widest(frame_.y_ticks) - label_width(y_label_) + text_height);
    add(colour_label_, middle,
        plot.right + bar_gap + bar_width + tick_room + widest(frame_.colour_ticks) + text_height);
  }

  const Chart& chart_;
  Frame frame_{};
  std::vector<std::string> x_label_, y_label_, colour_label_;
  double below_ = 0;  ///< the plot: the ticks of x
  bool legend_beside_ = false;
};

}  // namespace

Frame frame_of(const Chart& chart) {
  return Layout(chart).frame();
}

std::vector<std::string> line_labels(const Chart& chart) {
  std::vector<std::string> labels;
  for (const ReferenceLine& line : chart.lines)
    if (std::ranges::find(labels, line.label) == labels.end()) labels.push_back(line.label);
  return labels;
}

Pixel place_of(const Chart& chart, const Frame& frame, double position, double value) {
  const auto pixels = [](double exact) { return std::clamp(exact, -1e5, 1e5); };
  const Box& plot = frame.plot;
  return {pixels(plot.left + plot.width() * share(position, frame.x, chart.x.scale)),
          pixels(plot.bottom - plot.height() * share(value, frame.y, chart.y.scale))};
}

namespace {

std::string power_of_ten(int exponent) {
  static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent))) text += digits[c - '0'];
  return text;
}

double step_of(const Range& limits, int wanted, bool whole_numbers) {
  const double raw = (limits.upper - limits.lower) / wanted;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power >= raw * (1 - 1e-9)) step = factor * power;
  return whole_numbers ? std::max(step, 1.0) : step;
}

}  // namespace

Range limits(const std::vector<double>& values, Scale scale) {
  const bool logarithmic = scale == Scale::logarithmic;
  if (values.empty()) return logarithmic ? Range{1, 10} : Range{0, 1};
  const auto [least, most] = std::ranges::minmax(values);
  if (logarithmic) {
    const double room = std::max(std::pow(most / least, 0.03), most < 2 * least ? 1.5 : 1.0);
    return {least / room, most * room};
  }
  const double span = most - least;
  const double scale_of_values = std::max(std::abs(least), std::abs(most));
  const bool flat = span <= 1e-9 * scale_of_values;
  const double room = !flat ? 0.04 * span : scale_of_values > 0 ? 0.5 * scale_of_values : 1.0;
  return {least - room, most + room};
}

double share(double value, const Range& limits, Scale scale) {
  if (scale == Scale::linear) return (value - limits.lower) / (limits.upper - limits.lower);
  return std::log(value / limits.lower) / std::log(limits.upper / limits.lower);
}

std::string number_label(double number) {
  std::string text = fmt::format("{:.10g}", std::abs(number));
  if (const auto power = text.find('e'); power != std::string::npos) {
    const std::string factor = text.substr(0, power) == "1" ? "" : text.substr(0, power) + "×";
    text = factor + power_of_ten(std::stoi(text.substr(power + 1)));
  }
  return number < 0 ? "−" + text : text;
}

std::vector<Tick> linear_ticks(const Range& limits, int wanted, bool whole_numbers) {
  const double step = step_of(limits, wanted, whole_numbers);
  const double slack = 1e-9 * step;
  const double first = std::ceil((limits.lower - slack) / step);
  std::vector<Tick> ticks;
  for (int i = 0; i <= 2 * wanted; ++i) {
    const double position = (first + i) * step;
    if (position > limits.upper + slack) break;
    ticks.push_back({std::clamp(position, limits.lower, limits.upper), number_label(position)});
  }
  return ticks;
}

std::vector<Tick> logarithmic_ticks(const Range& limits, int wanted) {
  const int first = static_cast<int>(std::floor(std::log10(limits.lower)));
  const int last = static_cast<int>(std::ceil(std::log10(limits.upper)));
  const double decades = std::log10(limits.upper / limits.lower);
  const int stride = std::max(1, static_cast<int>(std::ceil(decades / wanted)));
  const bool plain = limits.lower >= 1e-3 && limits.upper < 1e5;
  std::vector<Tick> ticks;
  const auto add = [&](double position, const std::string& label) {
    if (position >= limits.lower && position <= limits.upper) ticks.push_back({position, label});
  };
  for (int exponent = first; exponent <= last; ++exponent) {
    const double power = std::pow(10, exponent);
    const bool labelled = exponent % stride == 0;
    add(power, !labelled ? "" : plain ? fmt::format("{:g}", power) : power_of_ten(exponent));
    for (int digit = 2; digit <= 9 && decades <= 8; ++digit) {
      // Less than two decades have too few powers of ten to read off a value.
      const bool label_digit = (decades < 2 && (digit == 2 || digit == 5)) ||
                               (decades < 1 && (digit == 3 || digit == 7)) || decades < 0.5;
      add(digit * power, label_digit ? number_label(digit * power) : "");
    }
  }
  const auto labels = std::ranges::count_if(ticks, [](const Tick& t) { return !t.label.empty(); });
  return labels < 2 && decades < 1 ? linear_ticks(limits, wanted, false) : ticks;
}

namespace {

constexpr double label_distance = 14;  // pixels
constexpr double beside = 4;     // pixels, from a curve's end to a label without a leader line
constexpr double farthest = 45;  // to a label with a leader line
constexpr std::size_t most = 6;  // with more labels a legend is easier to read
constexpr double widest_share = 0.45;  // of the chart's width, for the labels
constexpr double right_end = 0.97;     // of the plot's width: a curve ends at the right

/// Moves sorted labels apart to at least this distance, with the least total square of
/// displacements: less their distance from the first, their places are an isotonic regression, by
/// its minimax formula.
void move_apart(std::vector<EndLabel>& labels, double distance) {
  const auto mean = [&](std::size_t from, std::size_t to) {
    double sum = 0;
    for (std::size_t i = from; i <= to; ++i)
      sum += labels[i].end - distance * static_cast<double>(i);
    return sum / static_cast<double>(to - from + 1);
  };
  const double top = std::max(0.0, 1 - distance * static_cast<double>(labels.size() - 1));
  for (std::size_t i = 0; i < labels.size(); ++i) {
    double place = -1e9;
    for (std::size_t from = 0; from <= i; ++from) {
      double least = 1e9;
      for (std::size_t to = i; to < labels.size(); ++to) least = std::min(least, mean(from, to));
      place = std::max(place, least);
    }
    labels[i].place = std::clamp(place, 0.0, top) + distance * static_cast<double>(i);
  }
}

}  // namespace

std::vector<EndLabel> end_labels(const Chart& chart, const Range& x, const Range& y,
                                 double height) {
  std::vector<EndLabel> labels;
  if (!chart.areas.empty()) return {};  // which need a legend, with the series in it
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& series = chart.series[i];
    if (series.label.empty()) continue;
    if (series.mark == Mark::points || series.samples.empty()) return {};
    const Sample& last = series.samples.back();
    if (!last.value || share(last.position, x, chart.x.scale) < right_end) return {};
    const double end = share(*last.value, y, chart.y.scale);
    if (end < 0 || end > 1) return {};
    if (text_width(series.label) > widest_share * chart.width) return {};
    labels.push_back({series.label, i, end, end});
  }
  if (labels.size() < 2 || labels.size() > most) return {};
  std::stable_sort(labels.begin(), labels.end(),
                   [](const EndLabel& a, const EndLabel& b) { return a.end < b.end; });
  move_apart(labels, label_distance / height);
  for (const EndLabel& label : labels) {
    if (std::abs(label.place - label.end) > farthest / height) return {};
  }
  return labels;
}

bool need_leaders(const std::vector<EndLabel>& labels, double height) {
  return std::ranges::any_of(labels, [&](const EndLabel& label) {
    return std::abs(label.place - label.end) > beside / height;
  });
}

std::vector<PointName> names_of_points(const Chart& chart, const Frame& frame) {
  static constexpr Pixel directions[] = {{-0.8, -1.2}, {-1, 0},     {0.8, -1.2}, {0.8, 1.2},
                                         {1, 0},       {-0.8, 1.2}, {0.1, -2.2}, {0.1, 2.2}};
  constexpr double dot_size = 4, half_line = 6.5;  // half of each, pixels
  struct Dot {
    const Sample* sample;
    Pixel place;
    bool pale;
  };
  std::vector<Dot> dots;
  std::vector<Box> taken;
  for (const bool pale : {false, true}) {
    for (const Series& series : chart.series) {
      for (const Sample& sample : series.samples) {
        if (series.mark != Mark::points || series.pale != pale || !sample.value) continue;
        const Pixel at = place_of(chart, frame, sample.position, *sample.value);
        dots.push_back({&sample, at, pale});
        taken.push_back({at.x - dot_size, at.x + dot_size, at.y - dot_size, at.y + dot_size});
      }
    }
  }
  /// Takes the room for a name if there is some.
  const auto take = [&](const PointName& name) {
    const double length = text_width(name.text, 10) + 2;
    const double left = name.to_the_left ? name.place.x - length : name.place.x;
    const Box box{left, left + length, name.place.y - half_line, name.place.y + half_line};
    const Box& plot = frame.plot;
    const bool inside = box.left > plot.left && box.right < plot.right &&
                        box.bottom < plot.bottom && box.top > plot.top - half_line;
    const bool free = inside && std::ranges::none_of(taken, [&](const Box& other) {
                        return box.left < other.right && other.left < box.right &&
                               box.top < other.bottom && other.top < box.bottom;
                      });
    if (free) taken.push_back(box);
    return free;
  };
  std::vector<PointName> placed;
  for (const auto& [sample, dot, pale] : dots) {
    bool open = !sample->name.empty() && frame.plot.holds(dot);
    for (const double distance : {8.0, 16.0, 26.0, 40.0}) {
      const bool led = distance > 8;
      for (const Pixel& side : directions) {
        if (!open || (led && pale)) break;
        const PointName name{
            sample->name, dot, {dot.x + distance * side.x, dot.y + distance * side.y},
            side.x < 0,   led, pale};
        open = !take(name);
        if (!open) placed.push_back(name);
      }
    }
  }
  return placed;
}

}  // namespace ricochet::report
