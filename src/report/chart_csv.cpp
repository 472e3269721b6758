#include "src/report/chart_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "src/core/csv_field.h"

namespace ricochet::report {
namespace {

std::string field(const std::optional<double>& number) {
  return number ? fmt::format("{:.10g}", *number) : "";
}

/// A position on an axis: a number, or the name of a category.
std::string field(double position, const Axis& axis) {
  const auto place = static_cast<std::size_t>(std::max(std::round(position), 0.0));
  return place < axis.categories.size() ? csv_field(axis.categories[place]) : field(position);
}

std::string cells_as_csv(const Chart& chart) {
  const auto named = [](const std::string& label, const char* usual) {
    return csv_field(label.empty() ? usual : label);
  };
  std::string text =
      fmt::format("{},{},{}\n", named(chart.y.label, "row"), named(chart.x.label, "column"),
                  named(chart.heat_map->label, "value"));
  const auto& rows = chart.heat_map->rows;
  for (std::size_t row = rows.size(); row-- > 0;) {  // from the top
    for (std::size_t column = 0; column < rows[row].size(); ++column) {
      text += fmt::format("{},{},{}\n", csv_field(chart.y.categories[row]),
                          csv_field(chart.x.categories[column]), field(rows[row][column]));
    }
  }
  return text;
}

/// Rows of series, areas and lines, all with the same columns.
class Rows {
 public:
  explicit Rows(const Chart& chart) : chart_(chart) {
    for (const Series& series : chart.series) {
      spreads_ |=
          std::ranges::any_of(series.samples, [](const Sample& s) { return s.spread.has_value(); });
      names_ |=
          std::ranges::any_of(series.samples, [](const Sample& s) { return !s.name.empty(); });
    }
    spreads_ |= !chart.areas.empty();
  }

  std::string csv() {
    text_ = fmt::format("series,{},{}{}{}\n", csv_field(chart_.x.label), csv_field(chart_.y.label),
                        spreads_ ? ",lower,upper" : "", names_ ? ",name" : "");
    for (const Series& series : chart_.series) {
      for (const Sample& sample : series.samples) {
        add(series.label, field(sample.position, chart_.x), field(sample.value), sample.spread,
            sample.name);
      }
    }
    for (const Area& area : chart_.areas) {
      for (const auto& part : area.parts) {
        for (const Area::Edge& edge : part) {
          add(area.label.empty() ? area.name : area.label, field(edge.position, chart_.x), "",
              edge.between, "");
        }
      }
    }
    for (const ReferenceLine& line : chart_.lines) {
      const bool vertical = line.direction == Direction::vertical;
      add(line.label, vertical ? field(line.position, chart_.x) : "",
          vertical ? "" : field(line.position), {}, "");
    }
    return std::move(text_);
  }

 private:
  void add(const std::string& series, const std::string& x, const std::string& y,
           const std::optional<Range>& spread, const std::string& name) {
    text_ += fmt::format("{},{},{}", csv_field(series), x, y);
    if (spreads_) {
      text_ += spread ? fmt::format(",{},{}", field(spread->lower), field(spread->upper)) : ",,";
    }
    if (names_) text_ += "," + csv_field(name);
    text_ += "\n";
  }

  const Chart& chart_;
  bool spreads_ = false, names_ = false;
  std::string text_;
};

}  // namespace

std::string csv_of(const Chart& chart) {
  return chart.heat_map ? cells_as_csv(chart) : Rows(chart).csv();
}

}  // namespace ricochet::report
