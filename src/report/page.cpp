#include "src/report/page.h"

#include <fmt/format.h>

#include <set>
#include <stdexcept>

#include "embedded/look.h"
#include "embedded/page_template.h"
#include "embedded/summary_template.h"
#include "src/report/filled_text.h"
#include "src/report/gnuplot.h"
#include "src/report/text.h"

namespace ricochet::report {
namespace {

/// From this width on a chart has a row of its own.
constexpr int wide_chart = 560;  // pixels

/// For so many choices of a section reports/templates/look.css has rules.
constexpr std::size_t most_choices = 24;

void check(const Page& page) {
  std::set<std::string> ids, names;
  for (const Section& section : page.sections) {
    if (section.id.empty() || section.id.find_first_of(" \t\n") != std::string::npos)
      throw std::invalid_argument(
          fmt::format("section \"{}\": \"{}\" is no id: it is empty or has spaces", section.heading,
                      section.id));
    if (!ids.insert(section.id).second)
      throw std::invalid_argument(fmt::format("two sections have the id {}", section.id));
    for (const Table& table : section.tables) {
      for (const auto& row : table.rows) {
        if (row.size() == table.columns.size()) continue;
        throw std::invalid_argument(fmt::format("table \"{}\": a row of {} cells for {} columns",
                                                table.caption, row.size(), table.columns.size()));
      }
    }
    std::set<std::string> choices;
    for (const Figure& figure : section.figures) choices.insert(figure.choice);
    if (choices.size() > most_choices + choices.count(""))
      throw std::invalid_argument(fmt::format("section \"{}\" has {} choices; at most {} can be",
                                              section.heading, choices.size(), most_choices));
    for (const Figure& figure : section.figures)
      if (!names.insert(figure.chart.name).second)
        throw std::invalid_argument(fmt::format("two charts have the name {}", figure.chart.name));
  }
}

/// How a text is written into the page, or into its summary: a plain one, and one with links.
struct Writing {
  std::string (*plain)(std::string_view);
  std::string (*linked)(std::string_view);
};

Json data_of(const Table& table, const Writing& writing) {
  Json columns = Json::array(), rows = Json::array();
  for (const Column& column : table.columns) {
    columns.push_back(
        {{"title", writing.plain(column.title)}, {"left", column.alignment == Alignment::left}});
  }
  for (const auto& row : table.rows) {
    Json cells = Json::array();
    for (std::size_t i = 0; i < row.size(); ++i) {
      cells.push_back({{"text", writing.plain(row[i].text)},
                       {"left", columns.at(i)["left"]},
                       {"good", row[i].state == State::good},
                       {"bad", row[i].state == State::bad}});
    }
    rows.push_back({{"cells", std::move(cells)}});
  }
  return {{"caption", writing.linked(table.caption)},
          {"plain_caption", writing.plain(table.caption)},
          {"columns", std::move(columns)},
          {"rows", std::move(rows)}};
}

Json data_of(const Figure& figure, const std::string& svg, const Writing& writing) {
  const Chart& chart = figure.chart;
  return {{"name", chart.name},
          {"title", writing.plain(chart.title)},
          {"svg", svg},
          {"caption", writing.linked(figure.caption)},
          {"max_width", chart.width * 115 / 100},
          {"wide", chart.width >= wide_chart}};
}

/// The list of figures of a choice, which is added where it is new.
Json& figures_of_choice(const std::string& choice, Json& choices) {
  for (Json& known : choices) {
    if (known["choice"] == choice) return known["chosen"];
  }
  choices.push_back({{"choice", choice}, {"number", choices.size()}, {"chosen", Json::array()}});
  return choices.back()["chosen"];
}

Json data_of(const Page& page, const FileSet& files, const Writing& writing) {
  Json sections = Json::array();
  for (const Section& section : page.sections) {
    Json tables = Json::array(), figures = Json::array(), choices = Json::array();
    for (const Table& table : section.tables) tables.push_back(data_of(table, writing));
    for (const Figure& figure : section.figures) {
      Json drawn = data_of(figure, files.at(figure.chart.name + ".svg"), writing);
      if (figure.choice.empty()) {
        figures.push_back(std::move(drawn));
      } else {
        figures_of_choice(writing.plain(figure.choice), choices).push_back(std::move(drawn));
      }
    }
    sections.push_back({{"id", section.id},
                        {"heading", writing.plain(section.heading)},
                        {"paragraphs", list_of(section.paragraphs, writing.linked)},
                        {"tables", std::move(tables)},
                        {"has_figures", !figures.empty()},
                        {"figures", std::move(figures)},
                        {"has_choices", !choices.empty()},
                        {"choices", std::move(choices)}});
  }
  return {{"title", writing.plain(page.title)},
          {"intro", list_of(page.intro, writing.linked)},
          {"sections", std::move(sections)}};
}

}  // namespace

void write_page(const Page& page, const std::filesystem::path& folder, FileSet beside) {
  check(page);
  std::vector<Chart> charts;
  for (const Section& section : page.sections)
    for (const Figure& figure : section.figures) charts.push_back(figure.chart);
  const std::vector<std::string> svgs = to_svgs(charts);
  FileSet files = std::move(beside);
  for (std::size_t i = 0; i < charts.size(); ++i) files[charts[i].name + ".svg"] = svgs[i];
  Json html = data_of(page, files, {escape_html, html_with_links});
  html["look"] = embedded::look;
  const Json summary = data_of(page, files, {escape_markdown, escape_markdown});
  files["index.html"] = filled(embedded::page_template, {&html});
  files["summary.md"] = filled(embedded::summary_template, {&summary});
  replace_files(folder, files);
}

}  // namespace ricochet::report
