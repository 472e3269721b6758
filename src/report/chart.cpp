#include "src/report/chart.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "src/core/csv.h"

namespace ricochet::report {

namespace {

class Checker {
 public:
  explicit Checker(const Chart& chart) : chart_(chart) {}

  void require(bool holds, const std::string& reason) const {
    if (!holds) throw std::invalid_argument(reason);
  }
  void number(const std::string& where, double value, const Axis& axis) const {
    require(std::isfinite(value), fmt::format("{}: {} is not finite", where, value));
    // Beyond this, differences and ratios of two values may overflow.
    require(std::abs(value) <= 1e100, fmt::format("{}: {} is beyond 1e100", where, value));
    require(
        axis.scale == Scale::linear || value > 0,
        fmt::format("{}: {} must be > 0 on the logarithmic axis \"{}\"", where, value, axis.label));
    require(axis.scale == Scale::linear || value >= 1e-300,
            fmt::format("{}: {} is below 1e-300", where, value));
  }
  void range(const std::string& where, const Range& range, const Axis& axis) const {
    number(where, range.lower, axis);
    number(where, range.upper, axis);
    require(range.lower <= range.upper,
            fmt::format("{}: {} > {} is not a range", where, range.lower, range.upper));
  }
  void axis(const Axis& axis) const {
    if (!axis.range) return;
    const std::string where = fmt::format("axis \"{}\"", axis.label);
    range(where, *axis.range, axis);
    require(axis.range->lower < axis.range->upper, where + ": the range is empty");
  }
  void series(const Series& series) const {
    for (std::size_t i = 0; i < series.samples.size(); ++i) {
      const Sample& sample = series.samples[i];
      const std::string where = fmt::format("series \"{}\", sample {}", series.label, i);
      number(where, sample.position, chart_.x);
      if (sample.value) number(where, *sample.value, chart_.y);
      if (sample.spread) range(where, *sample.spread, chart_.y);
      require(sample.name.empty() || series.mark == Mark::points,
              where + ": only points have names");
      require(series.mark == Mark::points || i == 0 ||
                  series.samples[i - 1].position <= sample.position ||
                  (series.mark == Mark::line && is_gap_between(series.samples[i - 1], sample)),
              where + ": positions must rise");
    }
  }
  static bool is_gap_between(const Sample& a, const Sample& b) { return !a.value || !b.value; }

  void area(const Area& area) const {
    for (const auto& part : area.parts) {
      require(!part.empty(), fmt::format("area \"{}\": a part has no edge", area.label));
      for (std::size_t i = 0; i < part.size(); ++i) {
        const std::string where = fmt::format("area \"{}\", edge {}", area.label, i);
        number(where, part[i].position, chart_.x);
        range(where, part[i].between, chart_.y);
        require(i == 0 || part[i - 1].position <= part[i].position,
                where + ": positions must rise");
      }
    }
    require(!area.shade || (*area.shade >= 0 && *area.shade <= 1),
            fmt::format("area \"{}\": the shade must be within 0..1", area.label));
  }
  void heat_map(const HeatMap& map) const {
    require(chart_.areas.empty(), "has both areas and a heat map");
    require(chart_.series.empty(), "has both series and a heat map");
    require(
        !map.rows.empty() && map.rows.size() == chart_.y.categories.size(),
        fmt::format("{} rows for {} categories of y", map.rows.size(), chart_.y.categories.size()));
    const Axis colours{.label = map.label};
    if (map.range) range("colours", *map.range, colours);
    for (const auto& row : map.rows) {
      require(
          !row.empty() && row.size() == chart_.x.categories.size(),
          fmt::format("{} cells for {} categories of x", row.size(), chart_.x.categories.size()));
      for (const std::optional<double>& cell : row)
        if (cell) number("cell", *cell, colours);
    }
  }

 private:
  const Chart& chart_;
};

}  // namespace

void check(const Chart& chart) {
  const Checker checker(chart);
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  };
  checker.require(!chart.name.empty() && std::ranges::all_of(chart.name, allowed),
                  "the name must be of lower-case letters, digits and hyphens");
  checker.require(
      chart.width > 0 && chart.height > 0 && chart.width <= 10000 && chart.height <= 10000,
      fmt::format("{} x {} pixels must be between 1 and 10000", chart.width, chart.height));
  checker.axis(chart.x);
  checker.axis(chart.y);
  for (const Series& series : chart.series) checker.series(series);
  for (const Area& area : chart.areas) checker.area(area);
  for (const ReferenceLine& line : chart.lines)
    checker.number(fmt::format("reference line \"{}\"", line.label), line.position,
                   line.direction == Direction::vertical ? chart.x : chart.y);
  if (chart.heat_map) checker.heat_map(*chart.heat_map);
}

std::string description(const Chart& chart) {
  if (!chart.description.empty()) return chart.description;
  if (chart.heat_map) {
    std::vector<std::string> axes;  // names of rows and columns may suffice
    for (const Axis* axis : {&chart.x, &chart.y})
      if (!axis->label.empty()) axes.push_back(axis->label);
    return fmt::format("Heat map of {}{}{}.", chart.heat_map->label, axes.empty() ? "" : " over ",
                       fmt::join(axes, " and "));
  }
  std::vector<std::string> labels;
  for (const Area& area : chart.areas)
    if (!area.label.empty()) labels.push_back(area.label);
  for (const Series& series : chart.series)
    if (!series.label.empty()) labels.push_back(series.label);
  for (const ReferenceLine& line : chart.lines)
    if (std::ranges::find(labels, line.label) == labels.end()) labels.push_back(line.label);
  return fmt::format("{} against {}{}{}.", chart.y.label, chart.x.label, labels.empty() ? "" : ": ",
                     fmt::join(labels, ", "));
}

namespace {

std::string field(const std::optional<double>& number) {
  return number ? fmt::format("{:.10g}", *number) : "";
}

/// A position on an axis: a number, or the name of a category.
std::string field(double position, const Axis& axis) {
  const auto place = static_cast<std::size_t>(std::max(std::round(position), 0.0));
  return place < axis.categories.size() ? csv_field(axis.categories[place]) : field(position);
}

using CsvRows = std::vector<std::vector<std::string>>;  // the first has the names of the columns

CsvRows rows_of_cells(const Chart& chart) {
  const auto named = [](const std::string& label, const char* usual) {
    return csv_field(label.empty() ? usual : label);
  };
  CsvRows rows = {{named(chart.y.label, "row"), named(chart.x.label, "column"),
                   named(chart.heat_map->label, "value")}};
  for (std::size_t y = chart.heat_map->rows.size(); y-- > 0;)  // from the top
    for (std::size_t x = 0; x < chart.heat_map->rows[y].size(); ++x)
      rows.push_back({csv_field(chart.y.categories[y]), csv_field(chart.x.categories[x]),
                      field(chart.heat_map->rows[y][x])});
  return rows;
}

CsvRows rows_of_series(const Chart& chart) {
  CsvRows rows = {
      {"series", csv_field(chart.x.label), csv_field(chart.y.label), "lower", "upper", "name"}};
  const auto add = [&](const std::string& series, const std::string& x, const std::string& y,
                       const std::optional<Range>& spread, const std::string& name) {
    rows.push_back({csv_field(series), x, y, spread ? field(spread->lower) : "",
                    spread ? field(spread->upper) : "", csv_field(name)});
  };
  for (const Series& series : chart.series)
    for (const Sample& sample : series.samples)
      add(series.label, field(sample.position, chart.x), field(sample.value), sample.spread,
          sample.name);
  for (const Area& area : chart.areas)
    for (const auto& part : area.parts)
      for (const Area::Edge& edge : part)
        add(area.label.empty() ? area.name : area.label, field(edge.position, chart.x), "",
            edge.between, "");
  for (const ReferenceLine& line : chart.lines) {
    const bool vertical = line.direction == Direction::vertical;
    add(line.label, vertical ? field(line.position, chart.x) : "",
        vertical ? "" : field(line.position), {}, "");
  }
  return rows;
}

}  // namespace

std::string csv_of(const Chart& chart) {
  CsvRows rows = chart.heat_map ? rows_of_cells(chart) : rows_of_series(chart);
  for (std::size_t k = rows[0].size(); k-- > 3;) {
    const bool empty =
        std::all_of(rows.begin() + 1, rows.end(), [&](const auto& row) { return row[k].empty(); });
    for (auto& row : rows)
      if (empty) row.erase(row.begin() + static_cast<std::ptrdiff_t>(k));
  }
  std::string text;
  for (const auto& row : rows) text += fmt::format("{}\n", fmt::join(row, ","));
  return text;
}

}  // namespace ricochet::report
