#include "src/report/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/report/look.h"
#include "src/report/quote.h"
#include "src/report/script.h"
#include "src/report/ticks.h"

namespace ricochet::report {
namespace {

int widest(const std::vector<std::string>& texts) {
  int width = 0;
  for (const std::string& text : texts) width = std::max(width, text_width(text));
  return width;
}

/// A long legend beside the plot, a short one below it.
bool legend_at_right(const Frame& frame) {
  return frame.legend.size() > 4;
}

bool whole_numbers(const Chart& chart, bool positions) {
  return std::ranges::all_of(chart.series, [&](const Series& series) {
    return std::ranges::all_of(series.samples, [&](const Sample& sample) {
      const double value = positions ? sample.position : sample.value.value_or(0);
      return value == std::round(value);
    });
  });
}

std::string tick_list(const std::vector<Tick>& ticks) {
  std::string list;
  for (const Tick& tick : ticks)
    list += fmt::format("{}{} {:.10g} {}", list.empty() ? "" : ", ", quoted_tick(tick.label),
                        tick.position, tick.label.empty() ? 1 : 0);
  return "(" + list + ")";
}

std::string axis_script(const Chart& chart, const Frame& frame, bool x) {
  const Axis& axis = x ? chart.x : chart.y;
  const Range& range = x ? frame.x : frame.y;
  const int room = x ? plot_width(chart, frame) : plot_height(chart);
  std::string marks;
  std::string style = x ? "scale 0.5,0.3 offset 0,0.3" : "scale 0.5,0.3";
  if (axis.categories.empty()) {
    const int wanted = std::max(2, room / (x ? 65 : 38));
    const bool whole = !chart.series.empty() && whole_numbers(chart, x);
    marks = axis.scale == Scale::logarithmic
                ? tick_list(logarithmic_ticks(range, wanted))
                : fmt::format("{:.10g}", tick_step(range, wanted, whole));
  } else {
    const auto count = static_cast<int>(axis.categories.size());
    const int slot = std::max(1, room / count);
    const int needed = x ? widest(axis.categories) + 8 : 13;
    const bool turned = x && needed > slot && needed > 50;
    const int stride = 1 + ((turned ? 16 : needed) - 1) / slot;
    std::vector<Tick> names;
    for (int i = 0; i < count; i += stride)
      names.push_back({static_cast<double>(i), axis.categories[static_cast<std::size_t>(i)]});
    marks = tick_list(names);
    style = turned ? "scale 0 rotate by 35 right" : x ? "scale 0 offset 0,0.3" : "scale 0";
  }
  const char which = x ? 'x' : 'y';
  // A second, empty line of the label keeps the legend below at a distance.
  const char* const distance = x && !legend_at_right(frame) ? " . \"\\n \"" : "";
  return fmt::format(
      "set {0}label {1}{2} offset {3}\nset {0}range [{4:.10g}:{5:.10g}]\n{6}"
      "set {0}tics nomirror out {7} tc rgb '#444444' {8}\n",
      which, quoted(axis.label), distance, x ? "0,0.8" : "0,0", range.lower, range.upper,
      axis.scale == Scale::logarithmic ? fmt::format("set logscale {}\n", which) : "", style,
      marks);
}

std::string colour_script(const HeatMap& map, const Range& colours) {
  return fmt::format(
      "set palette defined {}\nset cbrange [{:.6g}:{:.6g}]\nset cblabel {} offset 0.8,0\n"
      "set cbtics scale 0.5 tc rgb '#444444' {:.10g}\n",
      palette(), colours.lower, colours.upper, quoted(map.label), tick_step(colours, 6, false));
}

std::string legend_script(const Chart& chart, const Frame& frame) {
  // One series needs no legend: title and axis say what it is.
  if (frame.legend.empty() || (frame.legend.size() == 1 && !chart.heat_map)) return "unset key\n";
  if (!legend_at_right(frame)) return "set key bmargin left horizontal Left reverse samplen 2\n";
  // Entries that need more than the plot's height would flow into a second column.
  const double fitting = plot_height(chart) / (19.0 * static_cast<double>(frame.legend.size()));
  return fmt::format("set key rmargin top vertical Left reverse samplen 2.5 spacing {:.3g}\n",
                     std::clamp(fitting, 0.8, 1.2));
}

}  // namespace

int text_width(const std::string& text) {
  return static_cast<int>(7 *
                          std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; }));
}

int plot_width(const Chart& chart, const Frame& frame) {
  const int labels = chart.y.categories.empty() ? 40 : widest(chart.y.categories);
  const int right = chart.heat_map            ? 75
                    : frame.room_for_ends > 0 ? frame.room_for_ends
                    : legend_at_right(frame)  ? widest(frame.legend) + 50
                                              : 15;
  return std::max(chart.width - 30 - labels - right, 50);
}

int plot_height(const Chart& chart) {
  return std::max(chart.height - 120, 50);
}

std::string frame_script(const Chart& chart, const Frame& frame) {
  std::string script = fmt::format(
      "set encoding utf8\nset minussign\nset format '%.10g'\n"
      "set terminal svg noenhanced size {},{} font '{},12' background 'white'\n"
      "set label 1 {} at screen 0, screen 1 offset 1,-1.3 left font '{},14'\nset tmargin 3\n"
      "set border {} lc rgb '#888888'\n",
      chart.width, chart.height, body_font, quoted(chart.title), title_font,
      chart.heat_map ? 0 : 3);
  if (!chart.heat_map) script += "set grid xtics ytics back lt 1 lw 0.7 lc rgb '#e4e4e4'\n";
  script += axis_script(chart, frame, true) + axis_script(chart, frame, false);
  if (chart.heat_map) script += colour_script(*chart.heat_map, frame.colours);
  if (frame.room_for_ends > 0) {
    script += fmt::format("set rmargin at screen {:.4f}\n",
                          1 - static_cast<double>(frame.room_for_ends) / chart.width);
  }
  return script + legend_script(chart, frame);
}

}  // namespace ricochet::report
