#include "src/report/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "src/report/text.h"

namespace ricochet::report {

void Results::add(const std::string& list, Part part) {
  parts[list].push_back(std::move(part));
}

const Value* Results::value(std::string_view name) const {
  const auto found = std::ranges::find(values, name, &std::pair<std::string, Value>::first);
  return found == values.end() ? nullptr : &found->second;
}

const ricochet::Table* Results::table(std::string_view name) const {
  const auto found = std::ranges::find(tables, name, &ricochet::Table::name);
  return found == tables.end() ? nullptr : &*found;
}

const Chart* Results::chart(std::string_view name) const {
  const auto found = std::ranges::find(charts, name, &Chart::name);
  return found == charts.end() ? nullptr : &*found;
}

namespace {

Json json_of(const Value& value, int digits) {
  return std::visit(
      [&](const auto& x) -> Json {
        using T = std::decay_t<decltype(x)>;
        if constexpr (std::is_same_v<T, std::monostate>) {
          return nullptr;
        } else if constexpr (std::is_same_v<T, double>) {
          return rounded(x, digits);
        } else {
          return x;
        }
      },
      value);
}

Value value_in(const Json& json) {
  if (json.is_null()) return {};
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  throw std::logic_error(json.dump() + " is no number, text or true, false, null");
}

/// Adds a member unless it says nothing.
void put(Json& object, const char* key, Json value) {
  const bool says_nothing =
      value.is_null() || value == "" || value == false || (value.is_structured() && value.empty());
  if (!says_nothing) object[key] = std::move(value);
}

Json json_of(const ricochet::Table& table) {
  Json columns = list_of(table.columns, [](const ricochet::Column& column) {
    Json json = {{"name", column.name}};
    put(json, "title", column.title);
    put(json, "format", column.format);
    return json;
  });
  Json rows = Json::array();
  for (const auto& row : table.rows) {
    Json cells = Json::array();
    for (std::size_t k = 0; k < row.size(); ++k)
      cells.push_back(json_of(row[k], table.columns[k].digits));
    rows.push_back(std::move(cells));
  }
  return {{"columns", std::move(columns)}, {"rows", std::move(rows)}};
}

ricochet::Table table_in(const std::string& name, const Json& json) {
  ricochet::Table table{name};
  for (const Json& column : json.at("columns")) {
    table.columns.push_back(
        {column.at("name"), column.value("title", ""), column.value("format", ""), 17});
  }
  for (const Json& row : json.at("rows")) {
    std::vector<Value> cells;
    for (const Json& cell : row) cells.push_back(value_in(cell));
    table.add_row(std::move(cells));
  }
  return table;
}

Json number(double x) {
  return rounded(x, usual_digits);
}

Json json_of(const std::optional<Range>& range) {
  return range ? Json{number(range->lower), number(range->upper)} : Json();
}

std::optional<Range> range_in(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end()) return {};
  return Range{found->at(0), found->at(1)};
}

Json json_of(const Axis& axis) {
  Json json = {{"label", axis.label}};
  put(json, "logarithmic", axis.scale == Scale::logarithmic);
  put(json, "range", json_of(axis.range));
  put(json, "categories", axis.categories);
  return json;
}

Axis axis_in(const Json& json) {
  return {json.at("label"), json.value("logarithmic", false) ? Scale::logarithmic : Scale::linear,
          range_in(json, "range"), json.value("categories", std::vector<std::string>())};
}

/// [position, value, lower, upper, name]; what is missing at the end is left out.
Json json_of(const Sample& sample) {
  Json json = {number(sample.position), sample.value ? number(*sample.value) : Json()};
  if (sample.spread || !sample.name.empty()) {
    json.push_back(sample.spread ? number(sample.spread->lower) : Json());
    json.push_back(sample.spread ? number(sample.spread->upper) : Json());
  }
  if (!sample.name.empty()) json.push_back(sample.name);
  return json;
}

Sample sample_in(const Json& json) {
  Sample sample{json.at(0), {}};
  if (!json.at(1).is_null()) sample.value = json.at(1).get<double>();
  if (json.size() > 3 && !json[2].is_null()) sample.spread = Range{json[2], json[3]};
  if (json.size() > 4) sample.name = json[4];
  return sample;
}

constexpr std::pair<Mark, const char*> marks[] = {
    {Mark::line, "line"}, {Mark::steps, "steps"}, {Mark::points, "points"}};

Json json_of(const Series& series) {
  Json json = {{"label", series.label}};
  for (const auto& [mark, name] : marks)
    if (mark == series.mark) json["mark"] = name;
  put(json, "pale", series.pale);
  put(json, "dark", series.dark);
  json["samples"] = list_of(series.samples, [](const Sample& sample) { return json_of(sample); });
  return json;
}

Series series_in(const Json& json) {
  Series series;
  series.label = json.at("label");
  for (const auto& [mark, name] : marks)
    if (json.at("mark") == name) series.mark = mark;
  for (const Json& sample : json.at("samples")) series.samples.push_back(sample_in(sample));
  series.pale = json.value("pale", false);
  series.dark = json.value("dark", false);
  return series;
}

Json json_of(const Area& area) {
  Json json = {{"label", area.label}};
  put(json, "name", area.name);
  if (area.shade) json["shade"] = number(*area.shade);
  json["parts"] = list_of(area.parts, [](const auto& part) {
    return list_of(part, [](const Area::Edge& edge) {
      return Json{number(edge.position), number(edge.between.lower), number(edge.between.upper)};
    });
  });
  return json;
}

Area area_in(const Json& json) {
  Area area{json.at("label"), {}, {}, json.value("name", "")};
  if (json.contains("shade")) area.shade = json["shade"].get<double>();
  for (const Json& part : json.at("parts")) {
    area.parts.emplace_back();
    for (const Json& edge : part)
      area.parts.back().push_back({edge.at(0), {edge.at(1), edge.at(2)}});
  }
  return area;
}

Json json_of(const HeatMap& map) {
  Json json = {{"label", map.label}};
  put(json, "range", json_of(map.range));
  put(json, "row_links", map.row_links);
  put(json, "column_links", map.column_links);
  json["rows"] = list_of(map.rows, [](const auto& row) {
    return list_of(row, [](const auto& cell) { return cell ? number(*cell) : Json(); });
  });
  return json;
}

HeatMap heat_map_in(const Json& json) {
  HeatMap map{json.at("label"), {}, range_in(json, "range")};
  map.row_links = json.value("row_links", std::vector<std::string>());
  map.column_links = json.value("column_links", std::vector<std::string>());
  for (const Json& row : json.at("rows")) {
    map.rows.emplace_back();
    for (const Json& cell : row)
      map.rows.back().push_back(cell.is_null() ? std::optional<double>() : cell.get<double>());
  }
  return map;
}

Json json_of(const ReferenceLine& line) {
  return {{"label", line.label},
          {line.direction == Direction::vertical ? "x" : "y", number(line.position)}};
}

ReferenceLine line_in(const Json& json) {
  const bool vertical = json.contains("x");
  return {vertical ? Direction::vertical : Direction::horizontal, json.at(vertical ? "x" : "y"),
          json.at("label")};
}

Json json_of(const Chart& chart) {
  Json json = {{"title", chart.title}, {"x", json_of(chart.x)}, {"y", json_of(chart.y)}};
  put(json, "series", list_of(chart.series, [](const Series& one) { return json_of(one); }));
  put(json, "areas", list_of(chart.areas, [](const Area& one) { return json_of(one); }));
  if (chart.heat_map) json["heat_map"] = json_of(*chart.heat_map);
  put(json, "lines", list_of(chart.lines, [](const ReferenceLine& one) { return json_of(one); }));
  json["size"] = {chart.width, chart.height};
  put(json, "description", chart.description);
  return json;
}

Chart chart_in(const std::string& name, const Json& json) {
  Chart chart{name, json.at("title"), axis_in(json.at("x")), axis_in(json.at("y"))};
  const auto read = [&](const char* key, auto& list, const auto& read_one) {
    for (const Json& one : json.value(key, Json::array())) list.push_back(read_one(one));
  };
  read("series", chart.series, series_in);
  read("areas", chart.areas, area_in);
  read("lines", chart.lines, line_in);
  if (json.contains("heat_map")) chart.heat_map = heat_map_in(json["heat_map"]);
  chart.width = json.at("size").at(0);
  chart.height = json.at("size").at(1);
  chart.description = json.value("description", "");
  return chart;
}

/// The entries under their names. Throws std::logic_error for two of one name.
template <class List, class NameOf, class Make>
Json by_name(const List& list, const NameOf& name_of, const Make& make) {
  Json object = Json::object();
  for (const auto& entry : list) {
    const std::string& name = name_of(entry);
    if (object.contains(name))
      throw std::logic_error(fmt::format("two results have the name {}", name));
    object[name] = make(entry);
  }
  return object;
}

}  // namespace

Json json_of(const Results& results) {
  Json json = Json::object();
  put(json, "values",
      by_name(
          results.values, [](const auto& entry) -> const auto& { return entry.first; },
          [](const auto& entry) { return json_of(entry.second, usual_digits); }));
  put(json, "tables",
      by_name(
          results.tables, [](const auto& table) -> const auto& { return table.name; },
          [](const auto& table) { return json_of(table); }));
  put(json, "charts",
      by_name(
          results.charts, [](const auto& chart) -> const auto& { return chart.name; },
          [](const auto& chart) { return json_of(chart); }));
  Json parts = Json::object();
  for (const auto& [name, list] : results.parts) {
    parts[name] = list_of(list, [](const Part& part) {
      Json one = {{"id", part.id}, {"title", part.title}};
      one.update(json_of(part.results));
      return one;
    });
  }
  put(json, "parts", std::move(parts));
  return json;
}

namespace {

/// Calls `use` with the name and the data of each member of the object of this name, if it is
/// there.
template <class Use>
void each_in(const Json& json, const char* name, const Use& use) {
  const auto found = json.find(name);
  if (found == json.end()) return;
  for (const auto& [key, value] : found->items()) use(key, value);
}

}  // namespace

Results results_in(const Json& json) {
  Results results;
  each_in(json, "values", [&](const std::string& name, const Json& value) {
    results.values.emplace_back(name, value_in(value));
  });
  each_in(json, "tables",
          [&](const std::string& name, const Json& table) { results.add(table_in(name, table)); });
  each_in(json, "charts",
          [&](const std::string& name, const Json& chart) { results.add(chart_in(name, chart)); });
  each_in(json, "parts", [&](const std::string& name, const Json& list) {
    for (const Json& part : list)
      results.add(name, {part.at("id"), part.at("title"), results_in(part)});
  });
  return results;
}

}  // namespace ricochet::report
