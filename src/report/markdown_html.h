#pragma once

#include <map>
#include <string>

#include "src/report/chart.h"
#include "src/report/drawing.h"
#include "src/report/json.h"

namespace ricochet::report {

struct Picture {
  Chart chart;
  DrawnChart drawn;
};

/// The pictures of a page, by file name.
using PagePictures = std::map<std::string, Picture>;

/// Stands in a filled page where a reader's own view of runs is.
inline constexpr const char* view_mark = "<!-- view -->";

/// A filled page, see markdown_page.h, as HTML that needs no other file and no network: pictures
/// stand in it, long tables fold, parts are chosen, sections have addresses and a list of contents.
/// `view` has the data of the runs that a script filters, see view.js. Throws std::runtime_error if
/// it is no Markdown.
std::string page_html(const std::string& markdown, const PagePictures& pictures,
                      const Json& view = nullptr);

}  // namespace ricochet::report
