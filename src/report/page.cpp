#include "src/report/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "embedded/chart_data_script.h"
#include "embedded/chart_links_script.h"
#include "embedded/charts_script.h"
#include "embedded/look.h"
#include "embedded/page_script.h"
#include "embedded/page_template.h"
#include "embedded/summary_template.h"
#include "embedded/view_choice_script.h"
#include "embedded/view_look.h"
#include "embedded/view_ranks_script.h"
#include "embedded/view_runs_script.h"
#include "embedded/view_script.h"
#include "embedded/view_template.h"
#include "src/core/files.h"
#include "src/core/instance.h"
#include "src/report/chart.h"
#include "src/report/drawing.h"
#include "src/report/page_template.h"
#include "src/report/text.h"

namespace ricochet::report {

namespace {

/// Charts from this width on have a row of their own.
constexpr int wide_chart = 560;  // pixels

/// Maximum number of choices of a section: reports/templates/look.css has rules for this many.
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

/// Functions that write a text into the page or into its summary: a plain one, one with links, and
/// one for what stands there as it is.
struct TextWriters {
  std::string (*plain)(std::string_view);
  std::string (*linked)(std::string_view);
  std::string (*code)(std::string_view);
  const char* file;  ///< of a page in its folder
  bool script;       ///< a page may have one, which reads what a link chooses: #family=hs
};

/// Escapes text line by line: what stands in <pre> keeps its lines.
std::string escape_lines(std::string_view text) {
  std::string html;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    html += (start > 0 ? "\n" : "") + escape_html(text.substr(start, end - start));
    start = end + 1;
  }
  return html;
}

std::string unchanged(std::string_view text) {
  return std::string(text);
}

/// The address of a place in a report, see Link.
std::string address_of(const std::string& place, const TextWriters& writing) {
  const std::size_t hash = std::min(place.find('#'), place.size());
  if (hash == 0) return writing.plain(place);
  if (!writing.script && place.find('=', hash) != std::string::npos) {
    return writing.plain(place.substr(0, hash)) + "/" + writing.file;
  }
  return writing.plain(place.substr(0, hash)) + "/" + writing.file +
         writing.plain(place.substr(hash));
}

/// A screen shows this many rows of a longer table until the reader asks for all.
constexpr std::size_t rows_at_first = 10;

/// A table with more columns is set closer.
constexpr std::size_t many_columns = 8;

/// `id` is unique on the page.
Json data_of(const Table& table, const std::string& id, const TextWriters& writing) {
  Json columns = Json::array(), rows = Json::array();
  std::vector<std::string> titles;
  for (const Column& column : table.columns) {
    titles.push_back(column.title);
    columns.push_back(
        {{"title", writing.plain(column.title)}, {"left", column.alignment == Alignment::left}});
  }
  const bool folds = table.rows.size() > rows_at_first + 2;
  for (const auto& row : table.rows) {
    Json cells = Json::array();
    for (std::size_t i = 0; i < row.size(); ++i) {
      cells.push_back({{"text", writing.plain(row[i].text)},
                       {"link", address_of(row[i].link, writing)},
                       {"left", columns.at(i)["left"]},
                       {"good", row[i].state == State::good},
                       {"bad", row[i].state == State::bad}});
    }
    rows.push_back({{"cells", std::move(cells)}, {"later", folds && rows.size() >= rows_at_first}});
  }
  return {{"caption", writing.linked(table.caption)},
          {"plain_caption", writing.plain(table.caption)},
          {"id", id},
          {"folds", folds},
          {"all", table.rows.size()},
          {"many_columns", table.columns.size() > many_columns},
          {"labels", writing.plain(column_labels(titles))},
          {"columns", std::move(columns)},
          {"rows", std::move(rows)}};
}

/// The picture with its numbers and what its cells lead to.
std::string with_links(const Figure& figure, const DrawnChart& drawn) {
  std::string html = html_of(figure.chart, drawn);
  if (!drawn.is_drawn() || figure.links.rows.empty()) return html;
  return html + data_script("chart-links", cell_links_data(figure.chart, figure.links));
}

Json data_of(const Figure& figure, const DrawnChart& drawn, const TextWriters& writing) {
  const Chart& chart = figure.chart;
  return {{"html", with_links(figure, drawn)},         {"markdown", markdown_of(drawn)},
          {"caption", writing.linked(figure.caption)}, {"frame", writing.plain(figure.frame)},
          {"title", writing.plain(chart.title)},       {"max_width", chart.width * 115 / 100},
          {"wide", chart.width >= wide_chart}};
}

/// Groups figures: the frames of one choice are placed together.
Json placed(std::vector<Json> figures) {
  Json frames = Json::array(), others = Json::array();
  for (Json& figure : figures)
    (figure["frame"] == "" ? others : frames).push_back(std::move(figure));
  for (Json& frame : frames) frame["last"] = &frame == &frames.back();
  return {{"figures", std::move(others)},
          {"has_frames", !frames.empty()},
          {"last_frame", frames.empty() ? 0 : frames.size() - 1},
          {"frames", frames}};
}

/// The figures by name, in the order in which names first occur.
using Named = std::vector<std::pair<std::string, std::vector<Json>>>;

void add(Named& named, const std::string& name, Json figure) {
  auto known = std::ranges::find_if(named, [&](const auto& entry) { return entry.first == name; });
  if (known == named.end()) known = named.insert(named.end(), {name, {}});
  known->second.push_back(std::move(figure));
}

Json list_under(const char* key, Named named) {
  Json list = Json::array();
  for (auto& [name, figures] : named) {
    list.push_back(placed(std::move(figures)));
    list.back()[key] = name;
    list.back()["number"] = list.size() - 1;
  }
  return list;
}

/// The form of a view of runs, with its data.
Json view_html(const Json& view) {
  if (view.is_null()) return nullptr;
  const Json data = {{"data", json_in_script(packed(view).dump())}};
  return filled(embedded::view_template, {&data});
}

/// The charts of a page, by their names.
using DrawnCharts = std::map<std::string, DrawnChart>;

Json data_of(const Section& section, const DrawnCharts& charts, const TextWriters& writing) {
  Json tables = Json::array();
  std::vector<Json> figures;
  Named choices, folds;
  for (const Table& table : section.tables) {
    const std::string id = fmt::format("{}-rows-{}", section.id, tables.size());
    tables.push_back(data_of(table, id, writing));
  }
  for (const Figure& figure : section.figures) {
    Json drawn = data_of(figure, charts.at(figure.chart.name), writing);
    if (!figure.fold.empty()) {
      add(folds, writing.plain(figure.fold), std::move(drawn));
    } else if (!figure.choice.empty()) {
      add(choices, writing.plain(figure.choice), std::move(drawn));
    } else {
      figures.push_back(std::move(drawn));
    }
  }
  Json data = placed(std::move(figures));
  data["has_figures"] = !data["figures"].empty() || !data["frames"].empty();
  data["id"] = section.id;
  data["heading"] = writing.plain(section.heading);
  data["paragraphs"] = list_of(section.paragraphs, writing.linked);
  data["code"] = list_of(section.code, writing.code);
  data["has_notes"] = !section.notes.empty();
  data["notes"] = list_of(section.notes, writing.linked);
  data["tables"] = std::move(tables);
  data["has_choices"] = !choices.empty();
  data["choices"] = list_under("choice", std::move(choices));
  data["folds"] = list_under("fold", std::move(folds));
  data["view"] = view_html(section.view);
  return data;
}

bool has_view(const Page& page) {
  return std::ranges::any_of(page.sections, [](const Section& one) { return !one.view.is_null(); });
}

bool has_cell_links(const Page& page) {
  return std::ranges::any_of(page.sections, [](const Section& section) {
    return std::ranges::any_of(section.figures,
                               [](const Figure& one) { return !one.links.rows.empty(); });
  });
}

/// Returns true if something on the page moves and so needs a script.
bool needs_script(const Page& page) {
  return has_view(page) || std::ranges::any_of(page.sections, [](const Section& section) {
           return std::ranges::any_of(section.figures,
                                      [](const Figure& figure) { return !figure.frame.empty(); });
         });
}

/// The scripts that the page needs.
Json scripts_of(const Page& page) {
  Json scripts = Json::array();
  const bool has_charts = std::ranges::any_of(
      page.sections, [](const Section& section) { return !section.figures.empty(); });
  if (needs_script(page)) scripts.push_back(embedded::page_script);
  if (has_view(page)) {
    for (const char* part :
         {embedded::charts_script, embedded::view_runs_script, embedded::view_ranks_script,
          embedded::view_choice_script, embedded::view_script}) {
      scripts.push_back(part);
    }
  }
  if (has_charts || has_view(page)) scripts.push_back(embedded::chart_data_script);
  if (has_cell_links(page)) scripts.push_back(embedded::chart_links_script);
  return scripts;
}

Json data_of(const Page& page, const DrawnCharts& charts, const TextWriters& writing) {
  Json sections = Json::array();
  for (const Section& section : page.sections)
    sections.push_back(data_of(section, charts, writing));
  return {{"title", writing.plain(page.title)},
          {"intro", list_of(page.intro, writing.linked)},
          {"has_background", !page.background.empty()},
          {"background", list_of(page.background, writing.linked)},
          {"scripts", scripts_of(page)},
          {"above", writing.plain(page.above)},
          {"has_further", !page.further.empty()},
          {"further", page.further},
          {"sections", std::move(sections)}};
}

DrawnCharts drawn_charts(const Page& page) {
  DrawnCharts charts;
  for (const Section& section : page.sections) {
    for (const Figure& figure : section.figures) {
      const Chart& chart = figure.chart;
      charts[chart.name] = figure.failure.empty()
                               ? draw(chart)
                               : DrawnChart{chart.name, chart.title, "", figure.failure};
    }
  }
  return charts;
}

}  // namespace

std::vector<std::string> write_page(const Page& page, const std::filesystem::path& folder,
                                    FileSet beside) {
  check(page);
  const DrawnCharts charts = drawn_charts(page);
  FileSet files = std::move(beside);
  std::vector<std::string> failures;
  for (const auto& [name, chart] : charts) {
    if (chart.is_drawn()) files[name + ".svg"] = chart.svg;
    if (!chart.is_drawn()) failures.push_back(failure_of(chart));
  }
  Json html =
      data_of(page, charts, {escape_html, html_with_links, escape_lines, "index.html", true});
  html["look"] = std::string(embedded::look) + (has_view(page) ? embedded::view_look : "");
  const Json summary =
      data_of(page, charts, {escape_markdown, escape_markdown, unchanged, "summary.md", false});
  files["index.html"] = filled(embedded::page_template, {&html});
  files["summary.md"] = filled(embedded::summary_template, {&summary});
  replace_files(folder, files);
  return failures;
}

namespace {

namespace fs = std::filesystem;

/// A line for each file: a hash of its text, and its name.
constexpr const char* manifest_name = "manifest.txt";

std::string hash_of(const std::string& text) {
  return fmt::format("{:016x}", seed_of(text, "", 0, 0));
}

std::string manifest_of(const FileSet& files) {
  std::string lines;
  for (const auto& [name, text] : files) lines += fmt::format("{} {}\n", hash_of(text), name);
  return lines;
}

/// Empty if there is no such file.
std::string content_of(const fs::path& file) {
  std::error_code none;
  return fs::is_regular_file(file, none) ? text_of_file(file) : "";
}

/// Returns the files of an earlier report that are unchanged and that no new file replaces.
std::vector<fs::path> stale_files(const fs::path& folder, const FileSet& files) {
  std::vector<fs::path> stale;
  std::istringstream manifest(content_of(folder / manifest_name));
  for (std::string hash, name; manifest >> hash && std::getline(manifest >> std::ws, name);) {
    const fs::path path = folder / name;
    const bool ours = fs::path(name).filename() == name &&
                      fs::is_regular_file(fs::symlink_status(path)) &&
                      hash_of(content_of(path)) == hash;
    if (ours && !files.contains(name)) stale.push_back(path);
  }
  return stale;
}

/// Writes all texts to the disk.
std::deque<TextDraft> drafts_of(const fs::path& folder, const FileSet& files) {
  std::deque<TextDraft> drafts;
  for (const auto& [name, text] : files)
    drafts.emplace_back(folder / name, text, SymbolicLinks::refused);
  return drafts;
}

}  // namespace

void add_files(const fs::path& folder, const FileSet& files) {
  const MadeFolder made(folder);
  std::deque<TextDraft> drafts = drafts_of(folder, files);
  const Uninterrupted whole;
  for (TextDraft& draft : drafts) draft.commit();
}

void replace_files(const fs::path& folder, const FileSet& files) {
  const MadeFolder made(folder);
  std::deque<TextDraft> drafts = drafts_of(folder, files);
  TextDraft manifest(folder / manifest_name, manifest_of(files), SymbolicLinks::refused);
  const std::vector<fs::path> stale = stale_files(folder, files);
  const Uninterrupted whole;
  for (TextDraft& draft : drafts) draft.commit();
  std::error_code ignored;
  for (const fs::path& path : stale) fs::remove(path, ignored);
  manifest.commit();
}

}  // namespace ricochet::report
