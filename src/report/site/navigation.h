#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/report/site/found_report.h"
#include "src/report/site/place.h"

namespace ricochet::site {

/// Returns the links to all places, as HTML for a page in the folder `here` of the site: "" is the
/// front page, "problems/count" a page of a report, "comparison/solvers/mads" one in such a page.
/// A word of the navigation leads to the first place of its group.
std::string navigation(const std::vector<Place>& places, const std::string& here);

/// Inserts the links into the pages of all places and reports that have room for them. Throws
/// OutputError.
void link_pages(const std::filesystem::path& site, const std::vector<Place>& places,
                const std::vector<FoundReport>& reports);

}  // namespace ricochet::site
