#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "src/report/chart.h"
#include "src/report/drawing.h"
#include "src/report/json.h"

namespace ricochet::report {

struct Picture {
  Chart chart;  ///< without a name: a picture that is none
  DrawnChart drawn;
};

/// Stands in a filled page where a reader's own view of runs is.
inline constexpr const char* view_mark = "<!-- view -->";

/// Where a link leads or a picture is; empty if nowhere, then its text stays.
using LinkTarget = std::function<std::string(const std::string&)>;

/// A link to a summary leads to its page.
std::string to_page(const std::string& link);

struct HtmlOptions {
  std::map<std::string, Picture> pictures = {};  ///< that stand in the page, by file name
  Json view = nullptr;  ///< data of the runs that a script filters, see view.js
  LinkTarget target = to_page;
  std::string look = "";  ///< CSS beside that of all pages
};

/// A heading of a page, its address in the page, and the text up to the next one.
struct PagePart {
  std::string heading;
  std::string anchor;  ///< empty: that of the page
  std::string text;    ///< plain
  std::string prose;   ///< the same, of tables only the names of rows
};

struct HtmlPage {
  std::string title, html;
  std::vector<PagePart> parts;
};

/// A page of Markdown, such as a filled one, see markdown_page.h, or a document, as HTML that needs
/// no other file and no network: pictures stand in it, long tables fold, parts are chosen, sections
/// have addresses as code hosts make them, and a list of contents. Comments are dropped. Throws
/// std::runtime_error if it is no Markdown.
HtmlPage html_page(const std::string& markdown, const HtmlOptions& options);

/// A whole page around a body of HTML: with the look of all pages, and room for the navigation.
std::string sheet_html(const std::string& title, const std::string& body,
                       const std::string& look = "", const std::vector<std::string>& scripts = {});

}  // namespace ricochet::report
