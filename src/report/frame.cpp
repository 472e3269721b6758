#include "src/report/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "src/report/text.h"

namespace ricochet::report {

namespace {

constexpr double least_width = 60, least_height = 30;  // of the plot, pixels
constexpr double text_height = 18;                     // of a line
constexpr double tick_room = 9;                        // a tick and the gap up to its label
constexpr double widest_name = 0.45;                   // of the picture, for a name
constexpr std::size_t rows_without_names_above = 20;   // of a heat map
const double sine = std::sin(name_angle * std::numbers::pi / 180);
const double cosine = std::cos(name_angle * std::numbers::pi / 180);

double widest(const std::vector<Tick>& ticks) {
  int width = 0;
  for (const Tick& tick : ticks) width = std::max(width, text_width(tick.label));
  return width;
}

bool whole_numbers(const Chart& chart, bool positions) {
  return !chart.series.empty() && std::ranges::all_of(chart.series, [&](const Series& series) {
    return std::ranges::all_of(series.samples, [&](const Sample& sample) {
      const double value = positions ? sample.position : sample.value.value_or(0);
      return value == std::round(value);
    });
  });
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
    ticks.push_back({static_cast<double>(i), names[i]});
  return ticks;
}

std::vector<LegendEntry> legend_of(const Chart& chart, const std::vector<EndLabel>& ends) {
  using Of = LegendEntry::Of;
  std::vector<LegendEntry> legend;
  if (chart.heat_map) {
    if (has_gaps(*chart.heat_map)) legend.push_back({Of::cells_without_value, 0, "no value"});
    return legend;
  }
  for (std::size_t i = 0; i < chart.areas.size(); ++i)
    if (!chart.areas[i].label.empty()) legend.push_back({Of::area, i, chart.areas[i].label});
  for (std::size_t i = 0; i < chart.series.size() && ends.empty(); ++i)
    if (!chart.series[i].label.empty()) legend.push_back({Of::series, i, chart.series[i].label});
  const std::vector<std::string> lines = line_labels(chart);
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (!lines[i].empty()) legend.push_back({Of::line, i, lines[i]});
  // A single entry needs no legend: title and axis name it.
  if (legend.size() == 1) legend.clear();
  for (LegendEntry& entry : legend) entry.label = shortened(entry.label, widest_name * chart.width);
  return legend;
}

/// Places the parts of a frame one after the other; each part may depend only on earlier ones.
class Layout {
 public:
  explicit Layout(const Chart& chart) : chart_(chart) {}

  Frame frame() {
    frame_.width = chart_.width;
    frame_.height = chart_.height;
    frame_.title = wrapped(chart_.title, chart_.width - 16, title_size);
    frame_.plot.top = 26 + title_height * static_cast<double>(frame_.title.size());
    frame_.x = data_limits(chart_, Direction::vertical);
    frame_.y = data_limits(chart_, Direction::horizontal);
    if (chart_.heat_map) frame_.colours = colour_limits(*chart_.heat_map);
    frame_.x_label = shortened(chart_.x.label, chart_.width - 40);
    place_y_ticks();
    // The height without a legend, which end labels replace.
    const double height = rough_height();
    frame_.ends = end_labels(chart_, frame_.x, frame_.y, height);
    frame_.legend = legend_of(chart_, frame_.ends);
    legend_beside_ = frame_.legend.size() > 4;
    place_sides(need_leaders(frame_.ends, height));
    place_x_ticks();
    place_bottom();
    if (legend_beside_) place_legend_beside();
    return std::move(frame_);
  }

 private:
  double rough_height() const {
    const double label = frame_.x_label.empty() ? 0 : text_height;
    return std::max(least_height, chart_.height - frame_.plot.top - text_height - label - 8);
  }

  void place_y_ticks() {
    const double room = rough_height();
    if (chart_.y.categories.empty()) {
      const int wanted = std::max(2, static_cast<int>(room / 38));
      frame_.y_ticks = chart_.y.scale == Scale::logarithmic
                           ? logarithmic_ticks(frame_.y, wanted)
                           : linear_ticks(frame_.y, wanted, whole_numbers(chart_, false));
    } else {
      frame_.y_ticks = name_ticks(chart_.y.categories, room, 13);
      for (Tick& tick : frame_.y_ticks)
        tick.label = shortened(tick.label, widest_name * chart_.width);
    }
    if (chart_.heat_map)
      frame_.colour_ticks =
          linear_ticks(frame_.colours, std::clamp(static_cast<int>(room / 25), 2, 6), false);
    frame_.y_label = shortened(chart_.y.label, std::max(room, 0.7 * chart_.height));
    if (chart_.heat_map) {
      frame_.colour_label = shortened(chart_.heat_map->label, std::max(room, 0.7 * chart_.height));
    }
  }

  void place_sides(bool leaders) {
    frame_.plot.left = (frame_.y_label.empty() ? 6 : 26) + widest(frame_.y_ticks) + tick_room;
    double right = 18;
    if (chart_.heat_map) {
      right = bar_gap + bar_width + tick_room + widest(frame_.colour_ticks) +
              (frame_.colour_label.empty() ? 6 : 28);
    } else if (!frame_.ends.empty()) {
      double label = 0;
      for (const EndLabel& end : frame_.ends) label = std::max<double>(label, text_width(end.text));
      right = label + 14 + (leaders ? leader_width : 0);
    } else if (legend_beside_) {
      double label = 0;
      for (const LegendEntry& entry : frame_.legend)
        label = std::max<double>(label, text_width(entry.label));
      right = label + key_width + 28;
    }
    const double width = std::max(least_width, chart_.width - frame_.plot.left - right);
    frame_.plot.right = frame_.plot.left + width;
    frame_.width = static_cast<int>(std::ceil(frame_.plot.right + right));
  }

  void place_x_ticks() {
    const std::vector<std::string>& names = chart_.x.categories;
    if (names.empty()) {
      const int wanted = std::max(2, static_cast<int>(frame_.plot.width() / 65));
      frame_.x_ticks = chart_.x.scale == Scale::logarithmic
                           ? logarithmic_ticks(frame_.x, wanted)
                           : linear_ticks(frame_.x, wanted, whole_numbers(chart_, true));
      return;
    }
    const double slot = frame_.plot.width() / static_cast<double>(names.size());
    const double needed = widest(name_ticks(names, 1e9, 0)) + 8;
    frame_.names_turned = needed > slot && needed > 50;
    frame_.x_ticks = name_ticks(names, frame_.plot.width(), frame_.names_turned ? 16 : needed);
    if (!frame_.names_turned) return;
    for (Tick& tick : frame_.x_ticks) {
      // The first names must end within the picture.
      const double before = frame_.plot.left + slot * (tick.position + 0.5) - 6;
      tick.label = shortened(tick.label, std::min(before / cosine, 260.0));
    }
  }

  /// The room for names of columns above a long heat map.
  double room_above() const {
    if (!frame_.names_above) return 0;
    return frame_.names_turned ? 14 + sine * widest(frame_.x_ticks) : text_height;
  }

  void place_bottom() {
    frame_.names_above = chart_.heat_map && !chart_.x.categories.empty() &&
                         chart_.y.categories.size() > rows_without_names_above;
    frame_.plot.top += room_above();
    double below = frame_.names_turned ? 14 + sine * widest(frame_.x_ticks) : text_height;
    if (!frame_.x_label.empty()) below += text_height;
    frame_.below_ticks = below;
    if (!frame_.legend.empty() && !legend_beside_) below += 4 + place_legend_below();
    const double height =
        std::max(least_height, chart_.height + room_above() - frame_.plot.top - below - 8);
    frame_.plot.bottom = frame_.plot.top + std::floor(height);
    frame_.height = static_cast<int>(std::ceil(frame_.plot.bottom + below + 8));
    for (LegendEntry& entry : frame_.legend) entry.place.y += frame_.plot.bottom;
  }

  /// Places the legend relative to the plot's bottom, which is not known yet. Returns the height of
  /// all lines.
  double place_legend_below() {
    Pixel next{frame_.plot.left, frame_.below_ticks + 4 + text_height};
    for (LegendEntry& entry : frame_.legend) {
      const double width = key_width + 6 + text_width(entry.label);
      if (next.x > frame_.plot.left && next.x + width > frame_.width) {
        next = {frame_.plot.left, next.y + text_height};
      }
      entry.place = next;
      next.x += width + 18;
    }
    return next.y - frame_.below_ticks - 4;
  }

  void place_legend_beside() {
    const auto lines = static_cast<double>(frame_.legend.size());
    const double distance = std::clamp(frame_.plot.height() / lines, 14.0, 20.0);
    double y = frame_.plot.top + 10;
    for (LegendEntry& entry : frame_.legend) {
      entry.place = {frame_.plot.right + 14, y};
      y += distance;
    }
    frame_.height = std::max(frame_.height, static_cast<int>(std::ceil(y - distance + 8)));
  }

  const Chart& chart_;
  Frame frame_{};
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

constexpr double line_height = 14;  // pixels
constexpr double beside = 4;        // pixels, from a curve's end to a label without a leader line
constexpr double farthest = 45;     // to a label with a leader line
constexpr std::size_t most = 6;     // with more labels a legend is easier to read
constexpr double widest_share = 0.45;  // of the chart's width, for the labels
constexpr double right_end = 0.97;     // of the plot's width: a curve ends at the right

/// Labels at the least distance from each other, centred around where they should be.
struct Cluster {
  std::size_t first, last;
  double sum = 0;  ///< sum of where its labels should be, relative to the lowest place

  double lowest(double distance, double top) const {
    const auto many = static_cast<double>(last - first + 1);
    return std::clamp(sum / many, 0.0, std::max(0.0, top - (many - 1) * distance));
  }
};

/// Moves sorted labels apart to at least this distance, with the least total displacement.
void move_apart(std::vector<EndLabel>& labels, double distance) {
  std::vector<Cluster> clusters;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    clusters.push_back({i, i, labels[i].end});
    while (clusters.size() > 1) {
      Cluster& below = clusters[clusters.size() - 2];
      const Cluster above = clusters.back();
      const auto many = static_cast<double>(below.last - below.first + 1);
      const double next = below.lowest(distance, 1) + many * distance;
      if (above.lowest(distance, 1) >= next) break;
      const auto added = static_cast<double>(above.last - above.first + 1);
      below.sum += above.sum - added * many * distance;
      below.last = above.last;
      clusters.pop_back();
    }
  }
  for (const Cluster& cluster : clusters) {
    for (std::size_t i = cluster.first; i <= cluster.last; ++i) {
      labels[i].place =
          cluster.lowest(distance, 1) + static_cast<double>(i - cluster.first) * distance;
    }
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
  move_apart(labels, line_height / height);
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

namespace {

constexpr double dot_size = 4;  // half, pixels
constexpr double half_line = 6.5;

bool meet(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

class Names {
 public:
  Names(const Chart& chart, const Frame& frame) : chart_(chart), frame_(frame) {
    for (const Series& series : chart.series) {
      if (series.mark != Mark::points) continue;
      for (const Sample& sample : series.samples) {
        if (!sample.value) continue;
        const Pixel dot = place_of(chart, frame, sample.position, *sample.value);
        taken_.push_back({dot.x - dot_size, dot.x + dot_size, dot.y - dot_size, dot.y + dot_size});
      }
    }
  }

  std::vector<PointName> all() {
    for (const bool pale : {false, true}) {
      for (const Series& series : chart_.series) {
        if (series.pale != pale) continue;
        for (const Sample& sample : series.samples) {
          if (sample.value && !sample.name.empty()) place(sample, pale);
        }
      }
    }
    return std::move(placed_);
  }

 private:
  void place(const Sample& sample, bool pale) {
    static constexpr std::array<Pixel, 8> directions{{{-0.8, -1.2},
                                                      {-1, 0},
                                                      {0.8, -1.2},
                                                      {0.8, 1.2},
                                                      {1, 0},
                                                      {-0.8, 1.2},
                                                      {0.1, -2.2},
                                                      {0.1, 2.2}}};
    const Pixel dot = place_of(chart_, frame_, sample.position, *sample.value);
    if (!frame_.plot.holds(dot)) return;
    for (const double distance : {8.0, 16.0, 26.0, 40.0}) {
      const bool led = distance > 8;
      if (led && pale) return;
      for (const Pixel& direction : directions) {
        const PointName name{
            sample.name,     dot, {dot.x + distance * direction.x, dot.y + distance * direction.y},
            direction.x < 0, led, pale};
        if (take(name)) return;
      }
    }
  }

  /// Keeps the name if there is room for it.
  bool take(const PointName& name) {
    const double length = text_width(name.text, 10) + 2;
    const double left = name.to_the_left ? name.place.x - length : name.place.x;
    const Box box{left, left + length, name.place.y - half_line, name.place.y + half_line};
    const Box& plot = frame_.plot;
    const bool inside = box.left > plot.left && box.right < plot.right &&
                        box.bottom < plot.bottom && box.top > plot.top - half_line;
    if (!inside || std::ranges::any_of(taken_, [&](const Box& b) { return meet(b, box); })) {
      return false;
    }
    taken_.push_back(box);
    placed_.push_back(name);
    return true;
  }

  const Chart& chart_;
  const Frame& frame_;
  std::vector<Box> taken_;
  std::vector<PointName> placed_;
};

}  // namespace

std::vector<PointName> names_of_points(const Chart& chart, const Frame& frame) {
  return Names(chart, frame).all();
}

}  // namespace ricochet::report
