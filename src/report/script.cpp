#include "src/report/script.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "src/report/end_labels.h"
#include "src/report/frame.h"
#include "src/report/look.h"
#include "src/report/names_of_points.h"
#include "src/report/polyline.h"
#include "src/report/quote.h"
#include "src/report/ticks.h"

namespace ricochet::report {
namespace {

/// Decimals that give the largest value three digits; none for whole numbers.
int cell_decimals(const std::vector<double>& values) {
  if (std::ranges::all_of(values, [](double v) { return v == std::round(v); })) return 0;
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return std::clamp(2 - static_cast<int>(std::floor(std::log10(largest))), 0, 4);
}

class Script {
 public:
  explicit Script(const Chart& chart) : chart_(chart) {
    for (const ReferenceLine& line : chart.lines)
      if (std::ranges::find(line_labels_, line.label) == line_labels_.end())
        line_labels_.push_back(line.label);
    frame_.x = chart.x.range.value_or(data_limits(chart.x, Direction::vertical));
    frame_.y = chart.y.range.value_or(data_limits(chart.y, Direction::horizontal));
    ends_ = end_labels(chart, frame_);
    frame_.room_for_ends = room_for(chart, ends_);
  }

  std::string text() {
    if (chart_.heat_map) {
      plot_heat_map(*chart_.heat_map);
    } else {
      plot_lines();
      for (std::size_t i = 0; i < chart_.series.size(); ++i) plot_spread(chart_.series[i], i);
      for (std::size_t i = 0; i < chart_.series.size(); ++i) plot_series(chart_.series[i], i);
      // In the legend they come last, though the series are drawn over them.
      for (std::size_t i = 0; i < line_labels_.size(); ++i)
        plot("keyentry", line_style(i), line_labels_[i]);
      std::vector<std::string> colours;
      for (std::size_t i = 0; i < chart_.series.size(); ++i) colours.push_back(look_of(i).colour);
      text_ += names_of_points(chart_, frame_) + end_label_script(chart_, ends_, colours);
    }
    if (!has_values_) add("set label 'no data' at graph 0.5, graph 0.5 center tc rgb '#666666'\n");
    return fmt::format("{}{}plot {}\n", frame_script(chart_, frame_), text_, plots_);
  }

 private:
  template <typename... Arguments>
  void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
  }

  /// Starts a block of data and returns its name.
  std::string begin_data() {
    const std::string name = fmt::format("$d{}", ++blocks_);
    add("{} << EOD\n", name);
    return name;
  }
  void end_data() { add("EOD\n"); }

  void plot(const std::string& data, const std::string& style, const std::string& label) {
    if (!label.empty()) frame_.legend.push_back(label);
    plots_ += fmt::format(", {} {} {}", data, style,
                          label.empty() ? "notitle" : "title " + quoted(label));
  }

  Range data_limits(const Axis& axis, Direction lines) const {
    const bool positions = lines == Direction::vertical;
    if (!axis.categories.empty()) return {-0.5, static_cast<double>(axis.categories.size()) - 0.5};
    std::vector<double> values;
    for (const ReferenceLine& line : chart_.lines)
      if (line.direction == lines) values.push_back(line.position);
    for (const Series& series : chart_.series) {
      for (const Sample& sample : series.samples) {
        if (positions) values.push_back(sample.position);
        if (!positions && sample.value) values.push_back(*sample.value);
        if (!positions && sample.value && sample.spread)
          values.insert(values.end(), {sample.spread->lower, sample.spread->upper});
      }
    }
    return limits(values, axis.scale);
  }

  void plot_lines() {
    // The last label first, so that the first lies on top.
    // NOTE: as many digits as the axes' ranges have: gnuplot drops a line whose ends are outside.
    for (std::size_t i = line_labels_.size(); i-- > 0;) {
      const std::string data = begin_data();
      for (const ReferenceLine& line : chart_.lines) {
        if (line.label != line_labels_[i]) continue;
        if (line.direction == Direction::vertical)
          add("{0:.10g} {1:.10g}\n{0:.10g} {2:.10g}\n\n", line.position, frame_.y.lower,
              frame_.y.upper);
        else
          add("{1:.10g} {0:.10g}\n{2:.10g} {0:.10g}\n\n", line.position, frame_.x.lower,
              frame_.x.upper);
      }
      end_data();
      plot(data, line_style(i), "");
    }
  }

  std::string line_style(std::size_t index) const {
    const LineLook look = line_look(index);
    return fmt::format("with lines lw {} lc rgb '{}' dt {}", look.width, look.colour, look.dash);
  }

  void plot_spread(const Series& series, std::size_t index) {
    const bool some = std::ranges::any_of(
        series.samples, [](const Sample& sample) { return sample.spread && sample.value; });
    if (!some) return;
    const SeriesLook look = look_of(index);
    if (series.mark == Mark::points) {
      plot_bars(series, look);
      return;
    }
    for (const std::vector<Sample>& part : polylines(series)) {
      // A band ends where the spread is unknown. Each stretch is a plot: gnuplot would join them.
      for (auto from = part.begin(); from != part.end();) {
        from = std::find_if(from, part.end(), [](const Sample& s) { return s.spread; });
        const auto to = std::find_if(from, part.end(), [](const Sample& s) { return !s.spread; });
        if (to - from > 1) {
          const std::string data = begin_data();
          for (auto sample = from; sample != to; ++sample)
            add("{:.6g} {:.6g} {:.6g}\n", sample->position, sample->spread->lower,
                sample->spread->upper);
          end_data();
          plot(data,
               fmt::format("with filledcurves fs transparent solid 0.14 noborder lc rgb '{}'",
                           look.colour),
               "");
        }
        from = to;
      }
    }
  }

  void plot_bars(const Series& series, const SeriesLook& look) {
    const std::string data = begin_data();
    for (const Sample& sample : series.samples) {
      if (!sample.value || !sample.spread) continue;
      add("{0:.6g} {1:.6g}\n{0:.6g} {2:.6g}\n\n", sample.position, sample.spread->lower,
          sample.spread->upper);
    }
    end_data();
    plot(data,
         fmt::format("with lines lw {} lc rgb '{}' dt solid", series.pale ? 0.5 : 1.2,
                     series.pale ? "#d4d4d4" : look.colour),
         "");
  }

  void plot_series(const Series& series, std::size_t index) {
    const SeriesLook look = look_of(index);
    const std::string dots =
        fmt::format("with points pt {} lw 2 lc rgb '{}' ps ", look.marker, look.colour);
    std::string data = begin_data();
    std::vector<Sample> alone;  // a line of a single sample has no length, and would not be seen
    bool joined = false;
    if (series.mark == Mark::points) {
      for (const Sample& sample : series.samples) {
        has_values_ |= sample.value.has_value();
        if (sample.value) add("{:.6g} {:.6g}\n", sample.position, *sample.value);
      }
    } else {
      for (const std::vector<Sample>& part : polylines(series)) {
        has_values_ = true;
        if (part.size() == 1) {
          alone.push_back(part.front());
          continue;
        }
        joined = true;
        for (const Sample& sample : part) add("{:.6g} {:.6g}\n", sample.position, *sample.value);
        add("\n");
      }
    }
    end_data();
    if (series.mark == Mark::points) {
      plot(data, dots + "0.8", series.label);
    } else {
      const std::string style =
          fmt::format("with lines lw 1.7 lc rgb '{}' dt {}", look.colour, look.dash);
      plot(joined ? data : "keyentry", style, ends_.empty() ? series.label : "");
    }
    if (alone.empty()) return;
    data = begin_data();
    for (const Sample& sample : alone) add("{:.6g} {:.6g}\n", sample.position, *sample.value);
    end_data();
    plot(data, dots + "0.4", "");
  }

  SeriesLook look_of(std::size_t index) const {
    const auto& all = chart_.series;
    if (all[index].pale) return pale_look();
    const auto before = std::count_if(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(index),
                                      [](const Series& series) { return series.pale; });
    return series_look(index - static_cast<std::size_t>(before));
  }

  void plot_heat_map(const HeatMap& map) {
    std::vector<double> values;
    for (const auto& row : map.rows)
      for (const auto& cell : row)
        if (cell) values.push_back(*cell);
    has_values_ = !values.empty();
    frame_.colours = map.range.value_or(Range{0, 1});
    if (!map.range && has_values_) {
      const auto [least, most] = std::ranges::minmax(values);
      frame_.colours = {least, most};
    }
    if (!(frame_.colours.lower < frame_.colours.upper))
      frame_.colours = limits({frame_.colours.lower}, Scale::linear);
    const std::string known = begin_data();
    cells(map, true);
    end_data();
    if (has_values_) plot(known, "with boxxyerror fs solid noborder lc palette", "");
    if (values.size() < map.rows.size() * map.rows.front().size()) {
      const std::string unknown = begin_data();
      cells(map, false);
      end_data();
      plot(unknown, "with boxxyerror fs pattern 4 lc rgb '#9a9a9a'", "no value");
    }
    const double columns = static_cast<double>(map.rows.front().size());
    const double rows = static_cast<double>(map.rows.size());
    if (!has_values_ || plot_width(chart_, frame_) / columns < 30 ||
        plot_height(chart_) / rows < 15)
      return;
    const int decimals = cell_decimals(values);
    const std::string numbers = begin_data();
    for (std::size_t row = 0; row < map.rows.size(); ++row)
      for (std::size_t column = 0; column < map.rows[row].size(); ++column)
        if (const auto& cell = map.rows[row][column])
          add("{} {} \"{:.{}f}\" {}\n", column, row, *cell, decimals,
              text_colour((*cell - frame_.colours.lower) /
                          (frame_.colours.upper - frame_.colours.lower)));
    end_data();
    plot(numbers, fmt::format("using 1:2:3:4 with labels font '{},10' tc rgb variable", body_font),
         "");
  }

  void cells(const HeatMap& map, bool known) {
    for (std::size_t row = 0; row < map.rows.size(); ++row) {
      for (std::size_t column = 0; column < map.rows[row].size(); ++column) {
        const std::optional<double>& cell = map.rows[row][column];
        if (cell.has_value() != known) continue;
        const double x = static_cast<double>(column), y = static_cast<double>(row);
        add("{} {} {} {} {} {}", x, y, x - 0.5, x + 0.5, y - 0.5, y + 0.5);
        if (cell) add(" {:.6g}", *cell);
        add("\n");
      }
    }
  }

  const Chart& chart_;
  std::vector<std::string> line_labels_;
  Frame frame_;
  std::vector<EndLabel> ends_;
  bool has_values_ = false;
  int blocks_ = 0;
  std::string text_;
  std::string plots_ = "NaN notitle";  // gnuplot fails where legend entries are all there is
};

}  // namespace

std::string gnuplot_script(const Chart& chart) {
  return Script(chart).text();
}

}  // namespace ricochet::report
