#pragma once

#include <filesystem>

#include "src/site/found_report.h"

namespace ricochet::site {

/// The links to all reports, as HTML for a page in the folder `here` of the site, "" for the front
/// page itself, "problems/count" for a page of a report.
std::string navigation(const std::vector<FoundReport>& reports, const std::string& here);

/// Puts the links into the pages of all reports, where their template leaves room for them. Throws
/// OutputError.
void link_pages(const std::filesystem::path& site, const std::vector<FoundReport>& reports);

}  // namespace ricochet::site
