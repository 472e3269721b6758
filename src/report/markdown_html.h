#pragma once

#include <map>
#include <string>

#include "src/report/chart.h"
#include "src/report/drawing.h"

namespace ricochet::report {

struct Picture {
  Chart chart;
  DrawnChart drawn;
};

/// The pictures of a page, by file name.
using PagePictures = std::map<std::string, Picture>;

/// A filled page, see markdown_page.h, as HTML that needs no other file and no network: pictures
/// stand in it, long tables fold, parts are chosen, sections have addresses and a list of contents.
/// Throws std::runtime_error if it is no Markdown.
std::string page_html(const std::string& markdown, const PagePictures& pictures);

}  // namespace ricochet::report
