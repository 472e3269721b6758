#include "src/report/chart_data.h"

#include <stdexcept>

#include "src/report/polyline.h"

namespace ricochet::report {
namespace {

std::optional<double> number_of(const Json& data) {
  return data.is_null() ? std::nullopt : std::optional(data.get<double>());
}

Json data_of(const Range& range) {
  return Json::array({range.lower, range.upper});
}

std::optional<Range> range_of(const Json& data, const char* key) {
  const auto found = data.find(key);
  if (found == data.end()) return std::nullopt;
  return Range{found->at(0).get<double>(), found->at(1).get<double>()};
}

Json data_of(const Axis& axis) {
  Json data = {{"label", axis.label}};
  if (axis.scale == Scale::logarithmic) data["scale"] = "logarithmic";
  if (axis.range) data["range"] = data_of(*axis.range);
  if (!axis.categories.empty()) data["categories"] = axis.categories;
  return data;
}

Axis axis_of(const Json& data) {
  return {data.at("label").get<std::string>(),
          data.value("scale", "linear") == "logarithmic" ? Scale::logarithmic : Scale::linear,
          range_of(data, "range"), data.value("categories", std::vector<std::string>{})};
}

constexpr const char* mark_names[] = {"line", "steps", "points"};

Mark mark_of(const std::string& name) {
  for (const Mark mark : {Mark::line, Mark::steps, Mark::points}) {
    if (name == mark_names[static_cast<std::size_t>(mark)]) return mark;
  }
  throw std::invalid_argument("a chart's data: there is no mark " + name);
}

/// Whether a line is the same without its sample i: it is level before and after.
bool is_needless(const Series& series, std::size_t i) {
  const auto& samples = series.samples;
  return series.mark == Mark::line && i > 0 && i + 1 < samples.size() &&
         same_height(samples[i - 1], samples[i]) && same_height(samples[i], samples[i + 1]);
}

/// A sample is [position, value], or [position, value, lower, upper] where it has a spread.
Json data_of(const Series& series) {
  Json samples = Json::array();
  for (std::size_t i = 0; i < series.samples.size(); ++i) {
    if (is_needless(series, i)) continue;
    const Sample& sample = series.samples[i];
    Json entry = Json::array({sample.position, sample.value});
    if (sample.spread) {
      entry.push_back(sample.spread->lower);
      entry.push_back(sample.spread->upper);
    }
    samples.push_back(std::move(entry));
  }
  return {{"label", series.label},
          {"mark", mark_names[static_cast<std::size_t>(series.mark)]},
          {"samples", std::move(samples)}};
}

Series series_of(const Json& data) {
  Series series{
      data.at("label").get<std::string>(), mark_of(data.at("mark").get<std::string>()), {}};
  for (const Json& entry : data.at("samples")) {
    Sample sample{entry.at(0).get<double>(), number_of(entry.at(1))};
    if (entry.size() == 4) sample.spread = Range{entry[2].get<double>(), entry[3].get<double>()};
    series.samples.push_back(sample);
  }
  return series;
}

Json data_of(const HeatMap& map) {
  Json rows = Json::array();
  for (const auto& row : map.rows) {
    Json cells = Json::array();
    for (const auto& cell : row) cells.push_back(cell);
    rows.push_back(std::move(cells));
  }
  Json data = {{"label", map.label}, {"rows", std::move(rows)}};
  if (map.range) data["range"] = data_of(*map.range);
  return data;
}

HeatMap map_of(const Json& data) {
  HeatMap map{data.at("label").get<std::string>(), {}, range_of(data, "range")};
  for (const Json& row : data.at("rows")) {
    auto& cells = map.rows.emplace_back();
    for (const Json& cell : row) cells.push_back(number_of(cell));
  }
  return map;
}

}  // namespace

Json data_of(const Chart& chart) {
  Json data = {{"name", chart.name},      {"title", chart.title},  {"x", data_of(chart.x)},
               {"y", data_of(chart.y)},   {"width", chart.width},  {"height", chart.height},
               {"series", Json::array()}, {"lines", Json::array()}};
  for (const Series& series : chart.series) data["series"].push_back(data_of(series));
  for (const ReferenceLine& line : chart.lines) {
    data["lines"].push_back(
        {{"direction", line.direction == Direction::vertical ? "vertical" : "horizontal"},
         {"position", line.position},
         {"label", line.label}});
  }
  if (chart.heat_map) data["heat_map"] = data_of(*chart.heat_map);
  if (!chart.description.empty()) data["description"] = chart.description;
  return data;
}

Chart chart_of(const Json& data) {
  Chart chart;
  chart.name = data.at("name").get<std::string>();
  chart.title = data.at("title").get<std::string>();
  chart.x = axis_of(data.at("x"));
  chart.y = axis_of(data.at("y"));
  chart.width = data.at("width").get<int>();
  chart.height = data.at("height").get<int>();
  for (const Json& series : data.at("series")) chart.series.push_back(series_of(series));
  for (const Json& line : data.at("lines")) {
    chart.lines.push_back(
        {line.at("direction") == "vertical" ? Direction::vertical : Direction::horizontal,
         line.at("position").get<double>(), line.at("label").get<std::string>()});
  }
  if (data.contains("heat_map")) chart.heat_map = map_of(data["heat_map"]);
  chart.description = data.value("description", "");
  return chart;
}

}  // namespace ricochet::report
