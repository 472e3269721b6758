#include "src/report/page_template.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "src/core/csv.h"
#include "src/core/names.h"

namespace ricochet::report {

namespace {

std::vector<std::string> paragraphs_of(const TemplatePart& part, std::string_view key,
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
      const TemplatePart own(*table);
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

Figure figure_of(const TemplatePart& chart, const Scopes& scopes, Mismatch mismatch) {
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

Section section_of(const TemplatePart& part, const Scopes& scopes, Mismatch mismatch,
                   DrawnPage& result) {
  Section section{filled(part.text("id"), scopes), filled(part.text("heading"), scopes)};
  section.paragraphs = paragraphs_of(part, "text", scopes);
  section.notes = paragraphs_of(part, "notes", scopes);
  if (part.has("view")) section.view = found_in(scopes, part.text("view"));
  for (const TemplatePart& table : part.parts("table")) {
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
  for (const TemplatePart& chart : part.parts("chart")) {
    for (const Scopes& place : places_of(chart, scopes)) {
      section.figures.push_back(figure_of(chart, place, mismatch));
    }
  }
  return section;
}

}  // namespace

DrawnPage drawn(const std::string& page_template, const Json& data, Mismatch mismatch) {
  const toml::table file = toml::parse(page_template);
  const TemplatePart root(file);
  DrawnPage result;
  result.headline = headline_of(root, {&data});
  result.page.title = result.headline.title;
  const Json finding = {{"finding", result.headline.finding}};
  const Scopes scopes = {&finding, &data};
  result.page.intro = paragraphs_of(root, "intro", scopes);
  result.page.background = paragraphs_of(root, "background", scopes);
  result.page.above = root.filled_text("above", scopes);
  result.page.further = data.value("pages", std::vector<std::string>());
  for (const TemplatePart& section : root.parts("section")) {
    for (const Scopes& place : places_of(section, scopes)) {
      result.page.sections.push_back(section_of(section, place, mismatch, result));
    }
  }
  result.epilogue = root.filled_text("epilogue", scopes);
  return result;
}

Headline headline_in(const std::string& page_template, const Json& data) {
  const toml::table file = toml::parse(page_template);
  return headline_of(TemplatePart(file), {&data});
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

std::string TemplatePart::text(std::string_view key) const {
  const auto value = (*table_)[key].value<std::string>();
  if (!value) throw std::logic_error(fmt::format("a template's {} must be a text", key));
  return *value;
}

std::string TemplatePart::filled_text(std::string_view key, const Scopes& scopes) const {
  return has(key) ? filled(text(key), scopes) : "";
}

std::vector<std::string> TemplatePart::texts(std::string_view key) const {
  const toml::array* array = list(key);
  if (array == nullptr) return {text(key)};
  std::vector<std::string> all;
  for (const toml::node& node : *array) all.push_back(node.value<std::string>().value());
  return all;
}

TemplatePart TemplatePart::part(std::string_view key) const {
  const toml::table* table = (*table_)[key].as_table();
  if (table == nullptr) throw std::logic_error(fmt::format("a template's {} must be a table", key));
  return TemplatePart(*table);
}

std::vector<TemplatePart> TemplatePart::parts(std::string_view key) const {
  std::vector<TemplatePart> all;
  if (const toml::array* array = list(key)) {
    for (const toml::node& node : *array) all.emplace_back(*node.as_table());
  }
  return all;
}

std::optional<double> TemplatePart::number(std::string_view key, const Scopes& scopes) const {
  const toml::node* node = table_->get(key);
  return node == nullptr ? std::nullopt : number_in(*node, scopes);
}

Scopes with(Scopes scopes, const Json& data) {
  scopes.push_back(&data);
  return scopes;
}

std::vector<Scopes> places_of(const TemplatePart& part, const Scopes& scopes) {
  std::vector<Scopes> places;
  if (part.has("when") && !holds(part.text("when"), scopes)) return places;
  if (part.has("each")) {
    for (const Json& entry : found_in(scopes, part.text("each"))) {
      places.push_back(with(scopes, entry));
    }
  } else {
    places.push_back(scopes);
  }
  if (part.has("data")) {
    for (Scopes& place : places) place.push_back(&found_in(place, part.filled_text("data", place)));
  }
  return places;
}

bool holds(const std::string& condition, const Scopes& scopes) {
  const bool negated = condition.starts_with('^');
  return is_yes(found_in(scopes, condition.substr(negated ? 1 : 0))) != negated;
}

std::optional<double> number_in(const toml::node& value, const Scopes& scopes) {
  if (const auto number = value.value<double>()) return number;
  const auto asked = value.value<std::string>();
  if (!asked) throw std::logic_error("a template's value must be a number or a name");
  const std::size_t colon = asked->find(':');
  const Json& data = found_in(scopes, asked->substr(0, colon));
  if (!data.is_number() && !data.is_null()) {
    throw std::logic_error(fmt::format("a template's {} is no number", *asked));
  }
  if (data.is_null() || !std::isfinite(data.get<double>())) return std::nullopt;
  const double number = data.get<double>();
  const std::string formulation = colon == std::string::npos ? "" : asked->substr(colon + 1);
  if (formulation.empty()) return number;
  if (formulation == "%") return 100 * number;
  if (formulation == "size") return std::abs(number);
  throw std::logic_error(fmt::format("a template's {}: must end in :% or :size", *asked));
}

namespace {

constexpr const char* columns = "columns";
constexpr const char* rows = "rows";

bool has_names_of_table(const Json& data) {
  return data.is_object() && data.size() == 2 && data.contains(columns) && data.contains(rows);
}

bool same_names(const Json& a, const Json& b) {
  return std::equal(a.items().begin(), a.items().end(), b.items().begin(), b.items().end(),
                    [](const auto& left, const auto& right) { return left.key() == right.key(); });
}

bool makes_table(const Json& list) {
  if (list.size() < 2 || !list[0].is_object() || list[0].empty()) return false;
  return std::ranges::all_of(
      list, [&](const Json& entry) { return entry.is_object() && same_names(entry, list[0]); });
}

Json table_of(const Json& list) {
  Json names = Json::array(), values = Json::array();
  for (const auto& [name, value] : list[0].items()) names.push_back(name);
  for (const Json& entry : list) {
    Json row = Json::array();
    for (const Json& value : entry) row.push_back(packed(value));
    values.push_back(std::move(row));
  }
  return {{columns, std::move(names)}, {rows, std::move(values)}};
}

bool is_table(const Json& data) {
  if (!has_names_of_table(data) || !data[columns].is_array() || !data[rows].is_array())
    return false;
  const auto is_name = [](const Json& name) { return name.is_string(); };
  return std::ranges::all_of(data[columns], is_name) &&
         std::ranges::all_of(data[rows], [&](const Json& row) {
           return row.is_array() && row.size() == data[columns].size();
         });
}

}  // namespace

Json packed(const Json& data) {
  if (!data.is_structured()) return data;
  if (has_names_of_table(data)) {
    throw std::logic_error("the data of a report have an object of only columns and rows");
  }
  if (data.is_array() && makes_table(data)) return table_of(data);
  Json copy = data;
  for (Json& part : copy) part = packed(part);
  return copy;
}

Json unpacked(Json data) {
  if (!data.is_structured()) return data;
  if (!is_table(data)) {
    for (Json& part : data) part = unpacked(std::move(part));
    return data;
  }
  Json list = Json::array();
  for (Json& row : data[rows]) {
    Json entry = Json::object();
    for (std::size_t i = 0; i < row.size(); ++i) {
      entry.push_back({data[columns][i].get<std::string>(), unpacked(std::move(row[i]))});
    }
    list.push_back(std::move(entry));
  }
  return list;
}

namespace {

Excerpt excerpt_of(const TemplatePart& part, const Scopes& scopes) {
  Excerpt excerpt{part.text("topic"),
                  part.filled_text("heading", scopes),
                  part.filled_text("text", scopes),
                  {},
                  {}};
  for (const TemplatePart& link : part.parts("links")) {
    for (const Scopes& place : places_of(link, scopes)) {
      excerpt.links.push_back({filled(link.text("text"), place), link.filled_text("to", place)});
    }
  }
  if (part.has("table")) excerpt.table = table_of(part.part("table"), scopes);
  return excerpt;
}

/// Omits the samples at or beyond the end of the range of y, where failed runs are drawn.
Chart inner_chart_of(const TemplatePart& part, const Scopes& scopes) {
  Chart chart = chart_of(part, scopes);
  for (Series& series : chart.series) {
    std::erase_if(series.samples, [&](const Sample& sample) {
      return !sample.value || (chart.y.range && *sample.value >= chart.y.range->upper);
    });
  }
  std::erase_if(chart.series, [](const Series& series) { return series.samples.empty(); });
  return chart;
}

}  // namespace

Headline headline_of(const TemplatePart& page, const Scopes& scopes) {
  Headline headline;
  headline.title = filled(page.text("title"), scopes);
  if (!page.has("headline")) return headline;
  const TemplatePart part = page.part("headline");
  headline.version = headline_version;
  headline.finding = part.filled_text("finding", scopes);
  headline.command = part.filled_text("made_by", scopes);
  headline.group = part.filled_text("group", scopes);
  headline.label = part.filled_text("label", scopes);
  for (const TemplatePart& excerpt : part.parts("excerpt")) {
    for (const Scopes& place : places_of(excerpt, scopes)) {
      headline.excerpts.push_back(excerpt_of(excerpt, place));
    }
  }
  for (const TemplatePart& chart : part.parts("chart")) {
    for (const Scopes& place : places_of(chart, scopes)) {
      headline.charts.push_back(inner_chart_of(chart, place));
    }
  }
  if (part.has("holds")) headline.holds = part.texts("holds");
  return headline;
}

}  // namespace ricochet::report
