#include "src/report/page_template.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "src/report/chart_template.h"

namespace ricochet::report {
namespace {

std::vector<std::string> paragraphs_of(const Part& part, std::string_view key,
                                       const Scopes& scopes) {
  std::vector<std::string> paragraphs;
  const toml::array* list = part.list(key);
  if (list == nullptr) return paragraphs;
  const auto add = [&](const std::string& text, const Scopes& place) {
    std::string paragraph = filled(text, place);
    if (!paragraph.empty()) paragraphs.push_back(std::move(paragraph));
  };
  for (const toml::node& node : *list) {
    if (const toml::table* table = node.as_table()) {
      const Part own(*table);
      for (const Scopes& place : places_of(own, scopes)) add(own.text("text"), place);
    } else {
      add(node.value<std::string>().value(), scopes);
    }
  }
  return paragraphs;
}

/// One column of the page, which a column of the template may make several of.
struct PlacedColumn {
  const Part* part;
  std::size_t entry;  ///< of the list that repeats it
};

Cell cell_of(const PlacedColumn& column, const Scopes& scopes, const Json& row) {
  Scopes in_cell = with(scopes, row);
  if (column.part->has("cells")) {
    in_cell.push_back(&found_in(in_cell, column.part->text("cells")).at(column.entry));
  }
  Cell cell{filled(column.part->text("value"), in_cell)};
  if (column.part->has("state")) {
    const Json& state = found_in(in_cell, column.part->text("state"));
    if (!state.is_null()) cell.state = state.get<bool>() ? State::good : State::bad;
  }
  return cell;
}

Table table_of(const Part& part, const Scopes& scopes) {
  Table table{filled(part.text("caption"), scopes), {}, {}};
  const std::vector<Part> columns = part.parts("columns");
  std::vector<PlacedColumn> placed;
  for (const Part& column : columns) {
    const std::vector<Scopes> places = places_of(column, scopes);
    for (std::size_t i = 0; i < places.size(); ++i) {
      table.columns.push_back({filled(column.text("title"), places[i]),
                               column.has("align") && column.text("align") == "left"
                                   ? Alignment::left
                                   : Alignment::right});
      placed.push_back({&column, i});
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
    for (const PlacedColumn& column : placed) cells.push_back(cell_of(column, scopes, row));
  }
  if (table.rows.size() < rows.size()) {
    table.caption += fmt::format(" The first {} of {}; all are in {}.csv.", table.rows.size(),
                                 rows.size(), filled(part.text("csv"), scopes));
  }
  return table;
}

std::string csv_field(const Json& data) {
  if (data.is_null()) return "";
  if (!data.is_string()) return data.dump();
  const auto& text = data.get_ref<const std::string&>();
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

/// The rows with all their members, those within members too; the first row has every name.
std::string csv_of(const Json& rows) {
  std::string text;
  std::vector<std::string> names;
  for (const Json& row : rows) {
    const Json flat = row.flatten();
    for (const auto& [name, value] : flat.items()) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  for (const std::string& name : names) {
    std::string title = name.substr(1);
    std::replace(title.begin(), title.end(), '/', '.');
    text += (text.empty() ? "" : ",") + title;
  }
  text += "\n";
  for (const Json& row : rows) {
    const Json flat = row.flatten();
    std::string line;
    for (const std::string& name : names) {
      if (&name != &names.front()) line += ",";
      if (flat.contains(name)) line += csv_field(flat[name]);
    }
    text += line + "\n";
  }
  return text;
}

Explorer explorer_of(const Part& part, const Scopes& scopes) {
  Explorer explorer{filled(part.text("caption"), scopes), {}, {}};
  for (const Json& row : found_in(scopes, part.text("settings"))) {
    const Scopes place = with(scopes, row);
    Setting setting{filled(part.text("setting"), place), {}, found_in(place, "own")};
    for (const Json& value : found_in(place, part.text("values"))) {
      setting.values.push_back(filled(part.text("value"), with(place, value)));
    }
    explorer.settings.push_back(std::move(setting));
  }
  for (const Json& row : found_in(scopes, part.text("answers"))) {
    explorer.answers.push_back(filled(part.text("answer"), with(scopes, row)));
  }
  return explorer;
}

Section section_of(const Part& part, const Scopes& scopes, DrawnPage& result) {
  Section section{filled(part.text("id"), scopes), filled(part.text("heading"), scopes)};
  section.paragraphs = paragraphs_of(part, "text", scopes);
  if (part.has("explorer")) section.explorer = explorer_of(part.part("explorer"), scopes);
  for (const Part& table : part.parts("table")) {
    for (const Scopes& place : places_of(table, scopes)) {
      section.tables.push_back(table_of(table, place));
      if (!table.has("csv")) continue;
      const std::string name = filled(table.text("csv"), place) + ".csv";
      if (!result.tables.emplace(name, csv_of(found_in(place, table.text("rows")))).second) {
        throw std::logic_error("two tables of a template have the file " + name);
      }
    }
  }
  for (const Part& chart : part.parts("chart")) {
    for (const Scopes& place : places_of(chart, scopes)) {
      section.figures.push_back({chart_of(chart, place), chart.filled_text("caption", place),
                                 chart.filled_text("choice", place),
                                 chart.filled_text("frame", place),
                                 chart.filled_text("fold", place)});
    }
  }
  return section;
}

}  // namespace

DrawnPage drawn(const std::string& page_template, const Json& data) {
  const toml::table file = toml::parse(page_template);
  const Part root(file);
  const Scopes scopes = {&data};
  DrawnPage result;
  result.page.title = filled(root.text("title"), scopes);
  result.page.intro = paragraphs_of(root, "intro", scopes);
  result.page.above = root.filled_text("above", scopes);
  result.page.further = data.value("pages", std::vector<std::string>());
  for (const Part& section : root.parts("section")) {
    for (const Scopes& place : places_of(section, scopes)) {
      result.page.sections.push_back(section_of(section, place, result));
    }
  }
  result.epilogue = root.filled_text("epilogue", scopes);
  return result;
}

Digits kept_digits(const std::string& page_template) {
  const toml::table file = toml::parse(page_template);
  Digits digits;
  if (const toml::table* table = file["digits"].as_table()) {
    for (const auto& [name, number] : *table) {
      digits.emplace(name.str(), number.value<int>().value());
    }
  }
  return digits;
}

}  // namespace ricochet::report
