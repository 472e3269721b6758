#include "src/report/page_template.h"

#include <algorithm>
#include <stdexcept>

#include "src/core/csv_field.h"
#include "src/core/label.h"
#include "src/core/name.h"
#include "src/report/chart_template.h"
#include "src/report/headline_template.h"
#include "src/report/table_template.h"

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

std::string field_of(const Json& data) {
  if (data.is_null()) return "";
  return data.is_string() ? csv_field(label(data.get_ref<const std::string&>())) : data.dump();
}

/// Returns the rows with all their members, including nested ones; the header has every name.
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
    text += (text.empty() ? "" : ",") + csv_field(title);
  }
  text += "\n";
  for (const Json& row : rows) {
    const Json flat = row.flatten();
    std::string line;
    for (const std::string& name : names) {
      if (&name != &names.front()) line += ",";
      if (flat.contains(name)) line += field_of(flat[name]);
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

Figure figure_of(const Part& chart, const Scopes& scopes, Mismatch mismatch) {
  try {
    Figure figure{chart_of(chart, scopes), chart.filled_text("caption", scopes),
                  chart.filled_text("choice", scopes), chart.filled_text("frame", scopes),
                  chart.filled_text("fold", scopes)};
    figure.links = cell_links_of(chart, scopes);
    return figure;
  } catch (const std::exception& error) {  // of the data's JSON, too
    if (mismatch == Mismatch::throws) throw;
    Figure figure;
    figure.chart.name = chart_name(chart, scopes);
    figure.failure = error.what();
    return figure;
  }
}

Section section_of(const Part& part, const Scopes& scopes, Mismatch mismatch, DrawnPage& result) {
  Section section{filled(part.text("id"), scopes), filled(part.text("heading"), scopes)};
  section.paragraphs = paragraphs_of(part, "text", scopes);
  section.notes = paragraphs_of(part, "notes", scopes);
  if (part.has("explorer")) section.explorer = explorer_of(part.part("explorer"), scopes);
  if (part.has("view")) section.view = found_in(scopes, part.text("view"));
  for (const Part& table : part.parts("table")) {
    for (const Scopes& place : places_of(table, scopes)) {
      section.tables.push_back(table_of(table, place));
      if (!table.has("csv")) continue;
      const std::string name = filled(table.text("csv"), place) + ".csv";
      if (!is_name(name)) throw std::logic_error(name + " is no name of a file for a table");
      if (!result.tables.emplace(name, csv_of(found_in(place, table.text("rows")))).second) {
        throw std::logic_error("two tables of a template have the file " + name);
      }
    }
  }
  for (const Part& chart : part.parts("chart")) {
    for (const Scopes& place : places_of(chart, scopes)) {
      section.figures.push_back(figure_of(chart, place, mismatch));
    }
  }
  return section;
}

}  // namespace

DrawnPage drawn(const std::string& page_template, const Json& data, Mismatch mismatch) {
  const toml::table file = toml::parse(page_template);
  const Part root(file);
  DrawnPage result;
  result.headline = headline_of(root, {&data});
  result.page.title = result.headline.title;
  const Json finding = {{"finding", result.headline.finding}};
  const Scopes scopes = {&finding, &data};
  result.page.intro = paragraphs_of(root, "intro", scopes);
  result.page.background = paragraphs_of(root, "background", scopes);
  result.page.above = root.filled_text("above", scopes);
  result.page.further = data.value("pages", std::vector<std::string>());
  for (const Part& section : root.parts("section")) {
    for (const Scopes& place : places_of(section, scopes)) {
      result.page.sections.push_back(section_of(section, place, mismatch, result));
    }
  }
  result.epilogue = root.filled_text("epilogue", scopes);
  return result;
}

Headline headline_in(const std::string& page_template, const Json& data) {
  const toml::table file = toml::parse(page_template);
  return headline_of(Part(file), {&data});
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
