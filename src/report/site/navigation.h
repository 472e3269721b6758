#pragma once

#include <filesystem>

#include "src/report/site/found_report.h"

namespace ricochet::site {

/// Returns the links to all reports, as HTML for a page in the folder `here` of the site: "" is the
/// front page, "problems/count" a page of a report, "comparison/solvers/mads" one in such a page.
std::string navigation(const std::vector<FoundReport>& reports, const std::string& here);

/// Inserts the links into the pages of all reports whose template has a place for them. Throws
/// OutputError.
void link_pages(const std::filesystem::path& site, const std::vector<FoundReport>& reports);

}  // namespace ricochet::site
