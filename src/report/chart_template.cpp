#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "src/report/page_template.h"

namespace ricochet::report {

namespace {

/// Returns the value that a word stands for; the first value if the word is missing.
template <class Value>
Value chosen(const TemplatePart& part, std::string_view key, const Scopes& scopes,
             std::initializer_list<std::pair<std::string_view, Value>> words) {
  if (!part.has(key)) return words.begin()->second;
  const std::string text = part.filled_text(key, scopes);
  for (const auto& [word, value] : words) {
    if (text == word) return value;
  }
  throw std::logic_error(fmt::format("a template's {} cannot be {}", key, text));
}

/// Converts text to lower-case letters and digits; other characters become hyphens.
std::string stem_of(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (!(c >= 'a' && c <= 'z') && !(c >= '0' && c <= '9')) c = '-';
  }
  return text;
}

std::optional<Range> range_between(const std::optional<double>& lower,
                                   const std::optional<double>& upper) {
  if (!lower || !upper) return std::nullopt;
  return Range{*lower, *upper};
}

std::optional<Range> range_of(const TemplatePart& part, const Scopes& scopes) {
  const toml::array* ends = part.list("range");
  if (ends == nullptr) return std::nullopt;
  if (ends->size() != 2) throw std::logic_error("a template's range must have two ends");
  return range_between(number_in((*ends)[0], scopes), number_in((*ends)[1], scopes));
}

/// The scopes of each category of an axis, in the order of the axis.
std::vector<Scopes> categories_of(const TemplatePart& axis, const Scopes& scopes) {
  std::vector<Scopes> places;
  if (!axis.has("categories")) return places;
  for (const Json& entry : found_in(scopes, axis.text("categories"))) {
    const Scopes place = with(scopes, entry);
    if (!axis.has("where") || holds(axis.text("where"), place)) places.push_back(place);
  }
  if (chosen<bool>(axis, "order", scopes, {{"up", false}, {"down", true}})) {
    std::reverse(places.begin(), places.end());
  }
  return places;
}

Axis axis_of(const TemplatePart& part, const Scopes& scopes) {
  Axis axis{part.filled_text("label", scopes),
            chosen<Scale>(part, "scale", scopes,
                          {{"linear", Scale::linear}, {"logarithmic", Scale::logarithmic}}),
            range_of(part, scopes)};
  for (const Scopes& place : categories_of(part, scopes)) {
    axis.categories.push_back(part.has("category") ? part.filled_text("category", place)
                                                   : filled("{{.}}", place));
  }
  return axis;
}

/// Returns true if the axis can show the number.
bool has_place(const Axis& axis, const std::optional<double>& number) {
  return number && (axis.scale == Scale::linear || *number > 0);
}

Series series_of(const TemplatePart& part, const Scopes& scopes, const Chart& chart) {
  Series series{
      part.filled_text("label", scopes),
      chosen<Mark>(part, "mark", scopes,
                   {{"line", Mark::line}, {"steps", Mark::steps}, {"points", Mark::points}}),
      {}};
  series.pale =
      chosen<bool>(part, "look", scopes, {{"coloured", false}, {"pale", true}, {"dark", false}});
  series.dark =
      chosen<bool>(part, "look", scopes, {{"coloured", false}, {"pale", false}, {"dark", true}});
  const auto add = [&](const std::optional<double>& x, const std::optional<double>& y,
                       const std::optional<Range>& spread = {}, const std::string& name = {}) {
    if (!has_place(chart.x, x)) return;
    series.samples.push_back({*x, has_place(chart.y, y) ? y : std::nullopt, spread, name});
  };
  if (const toml::array* samples = part.list("samples")) {
    for (const toml::node& node : *samples) {
      const toml::array& sample = *node.as_array();
      add(number_in(sample.at(0), scopes), number_in(sample.at(1), scopes));
    }
    return series;
  }
  double number = 0;
  for (const std::string& rows : part.texts("rows")) {
    for (const Json& row : found_in(scopes, rows)) {
      const Scopes in_row = with(scopes, row);
      const double own = number++;
      if (part.has("where") && !holds(part.text("where"), in_row)) continue;
      add(part.has("x") ? part.number("x", in_row) : own, part.number("y", in_row),
          range_between(part.number("lower", in_row), part.number("upper", in_row)),
          part.filled_text("name", in_row));
    }
  }
  const bool sorts = chosen<bool>(part, "order", scopes, {{"up", true}, {"given", false}});
  if (series.mark != Mark::points && sorts) {
    std::ranges::stable_sort(series.samples, {}, &Sample::position);
  }
  if (part.has("start") && !series.samples.empty()) {
    const double first = series.samples.front().position;
    series.samples.insert(series.samples.begin(), {first, part.number("start", scopes)});
  }
  return series;
}

Area area_of(const TemplatePart& part, const Scopes& scopes) {
  Area area{part.filled_text("label", scopes),
            part.number("shade", scopes),
            {},
            part.filled_text("name", scopes)};
  for (const Json& edges : found_in(scopes, part.text("parts"))) {
    auto& added = area.parts.emplace_back();
    for (const Json& edge : edges) {
      added.push_back(
          {edge.at(0).get<double>(), {edge.at(1).get<double>(), edge.at(2).get<double>()}});
    }
  }
  return area;
}

HeatMap heat_map_of(const TemplatePart& part, const TemplatePart& y, const Scopes& scopes) {
  HeatMap map{part.filled_text("label", scopes), {}, range_of(part, scopes)};
  for (const Scopes& row : categories_of(y, scopes)) {
    auto& cells = map.rows.emplace_back();
    for (const Json& cell : found_in(row, part.text("cells"))) {
      const Scopes in_cell = with(row, cell);
      cells.push_back(part.number("value", in_cell));
    }
  }
  return map;
}

}  // namespace

std::string chart_name(const TemplatePart& part, const Scopes& scopes) {
  return stem_of(filled(part.text("name"), scopes));
}

Chart chart_of(const TemplatePart& part, const Scopes& scopes) {
  Chart chart;
  chart.name = chart_name(part, scopes);
  chart.title = filled(part.text("title"), scopes);
  chart.x = axis_of(part.part("x"), scopes);
  chart.y = axis_of(part.part("y"), scopes);
  for (const TemplatePart& area : part.parts("areas")) {
    for (const Scopes& place : places_of(area, scopes)) chart.areas.push_back(area_of(area, place));
  }
  for (const TemplatePart& series : part.parts("series")) {
    for (const Scopes& place : places_of(series, scopes)) {
      chart.series.push_back(series_of(series, place, chart));
    }
  }
  for (const TemplatePart& line : part.parts("lines")) {
    const bool vertical = line.has("vertical");
    for (const Scopes& place : places_of(line, scopes)) {
      const auto position = line.number(vertical ? "vertical" : "horizontal", place);
      if (!position) continue;
      chart.lines.push_back({vertical ? Direction::vertical : Direction::horizontal, *position,
                             line.filled_text("label", place)});
    }
  }
  if (part.has("heat_map")) {
    chart.heat_map = heat_map_of(part.part("heat_map"), part.part("y"), scopes);
  }
  const auto pixels = [&](std::string_view key, int usual) {
    return static_cast<int>(part.number(key, scopes).value_or(usual));
  };
  chart.width = pixels("width", chart.width);
  chart.height = pixels("height", chart.height) +
                 pixels("row_height", 0) * static_cast<int>(chart.y.categories.size());
  chart.description = part.filled_text("description", scopes);
  return chart;
}

CellLinks cell_links_of(const TemplatePart& part, const Scopes& scopes) {
  CellLinks links;
  if (!part.has("heat_map") || !part.part("heat_map").has("row_link")) return links;
  const TemplatePart map = part.part("heat_map");
  for (const Scopes& row : categories_of(part.part("y"), scopes)) {
    links.rows.push_back(map.filled_text("row_link", row));
  }
  for (const Scopes& column : categories_of(part.part("x"), scopes)) {
    links.columns.push_back(map.filled_text("column_link", column));
  }
  return links;
}

namespace {

/// One column of the page; a column of the template may produce several.
struct PlacedColumn {
  const TemplatePart* part;
  std::size_t entry;  ///< index in the list that repeats it
  Scopes scopes;      ///< with that entry
};

Cell cell_of(const PlacedColumn& column, const Json& row) {
  Scopes in_cell = with(column.scopes, row);
  if (column.part->has("cells")) {
    in_cell.push_back(&found_in(in_cell, column.part->text("cells")).at(column.entry));
  }
  Cell cell{filled(column.part->text("value"), in_cell)};
  if (column.part->has("state")) {
    const Json& state = found_in(in_cell, column.part->text("state"));
    if (!state.is_null()) cell.state = state.get<bool>() ? State::good : State::bad;
  }
  cell.link = column.part->filled_text("link", in_cell);
  return cell;
}

}  // namespace

Table table_of(const TemplatePart& part, const Scopes& scopes) {
  Table table{filled(part.text("caption"), scopes), {}, {}};
  const std::vector<TemplatePart> columns = part.parts("columns");
  std::vector<PlacedColumn> placed;
  for (const TemplatePart& column : columns) {
    const std::vector<Scopes> places = places_of(column, scopes);
    for (std::size_t i = 0; i < places.size(); ++i) {
      table.columns.push_back({filled(column.text("title"), places[i]),
                               column.has("align") && column.text("align") == "left"
                                   ? Alignment::left
                                   : Alignment::right});
      placed.push_back({&column, i, places[i]});
    }
  }
  if (const toml::array* rows = part.list("rows")) {
    for (const toml::node& row : *rows) {
      auto& cells = table.rows.emplace_back();
      for (const toml::node& text : *row.as_array()) {
        cells.push_back({filled(text.value<std::string>().value(), scopes)});
      }
    }
    return table;
  }
  const Json& rows = found_in(scopes, part.text("rows"));
  const auto most = part.number("most", scopes);
  for (const Json& row : rows) {
    if (most && static_cast<double>(table.rows.size()) >= *most) break;
    auto& cells = table.rows.emplace_back();
    for (const PlacedColumn& column : placed) cells.push_back(cell_of(column, row));
  }
  if (table.rows.size() < rows.size()) {
    const std::string all =
        part.has("csv") ? "; all are in " + part.filled_text("csv", scopes) + ".csv" : "";
    table.caption += fmt::format(" The first {} of {}{}.", table.rows.size(), rows.size(), all);
  }
  return table;
}

}  // namespace ricochet::report
