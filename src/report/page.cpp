#include "src/report/page.h"

#include <fmt/format.h>

#include <kainjow/mustache.hpp>
#include <set>
#include <stdexcept>

#include "embedded/page_template.h"
#include "src/report/gnuplot.h"
#include "src/report/text.h"

namespace ricochet::report {
namespace {

namespace mustache = kainjow::mustache;

/// From this width on a chart has a row of its own.
constexpr int wide_chart = 560;  // pixels

void check(const Page& page) {
  std::set<std::string> ids, names;
  for (const Section& section : page.sections) {
    if (section.id.empty() || section.id.find_first_of(" \t\n") != std::string::npos)
      throw std::invalid_argument(
          fmt::format("section \"{}\": \"{}\" is no id: it is empty or has spaces", section.heading,
                      section.id));
    if (!ids.insert(section.id).second)
      throw std::invalid_argument(fmt::format("two sections have the id {}", section.id));
    for (const Figure& figure : section.figures)
      if (!names.insert(figure.chart.name).second)
        throw std::invalid_argument(fmt::format("two charts have the name {}", figure.chart.name));
  }
}

mustache::data paragraphs_data(const std::vector<std::string>& paragraphs) {
  mustache::data list{mustache::data::type::list};
  for (const std::string& text : paragraphs) list << mustache::data{"html", html_with_links(text)};
  return list;
}

mustache::data section_data(const Section& section, const FileSet& files) {
  mustache::data tables{mustache::data::type::list};
  for (const Table& table : section.tables) {
    mustache::data entry{"html", to_html(table)};
    entry.set("caption", table.caption);
    tables << entry;
  }
  mustache::data figures{mustache::data::type::list};
  for (const Figure& figure : section.figures) {
    mustache::data entry{"svg", files.at(figure.chart.name + ".svg")};
    entry.set("caption", html_with_links(figure.caption));
    entry.set("max_width", std::to_string(figure.chart.width * 115 / 100));
    entry.set("wide", figure.chart.width >= wide_chart);
    figures << entry;
  }
  mustache::data data{"id", section.id};
  data.set("heading", section.heading);
  data.set("paragraphs", paragraphs_data(section.paragraphs));
  data.set("tables", tables);
  data.set("has_figures", !section.figures.empty());
  data.set("figures", figures);
  return data;
}

std::string html(const Page& page, const FileSet& files) {
  mustache::data sections{mustache::data::type::list};
  for (const Section& section : page.sections) sections << section_data(section, files);
  mustache::data data{"title", page.title};
  data.set("intro", paragraphs_data(page.intro));
  data.set("sections", sections);
  mustache::mustache sheet{embedded::page_template};
  const std::string text = sheet.render(data);
  if (!sheet.is_valid()) throw std::logic_error("the page's template: " + sheet.error_message());
  return text;
}

std::string summary(const Page& page) {
  std::string text = fmt::format("# {}\n", escape_markdown(page.title));
  const auto add_paragraphs = [&text](const std::vector<std::string>& paragraphs) {
    for (const std::string& paragraph : paragraphs)
      text += fmt::format("\n{}\n", escape_markdown(paragraph));
  };
  add_paragraphs(page.intro);
  for (const Section& section : page.sections) {
    text += fmt::format("\n## {}\n", escape_markdown(section.heading));
    add_paragraphs(section.paragraphs);
    for (const Table& table : section.tables) text += fmt::format("\n{}", to_markdown(table));
    for (const Figure& figure : section.figures) {
      text +=
          fmt::format("\n![{}]({}.svg)\n", escape_markdown(figure.chart.title), figure.chart.name);
      if (!figure.caption.empty()) text += fmt::format("\n{}\n", escape_markdown(figure.caption));
    }
  }
  return text;
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
  files["index.html"] = html(page, files);
  files["summary.md"] = summary(page);
  replace_files(folder, files);
}

}  // namespace ricochet::report
