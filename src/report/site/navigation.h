#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/report/site/entries.h"

namespace ricochet::site {

/// A page that the navigation lists under one of its words.
struct Place {
  std::string group;  ///< the word
  std::string label;
  std::string folder;                   ///< inside the site
  std::vector<std::string> pages = {};  ///< folders of pages inside its own
};

/// The words of the navigation, in their order.
inline constexpr const char* groups[] = {"Machine",    "Solvers", "Robustness",
                                         "Simulation", "Paper",   "Data"};

/// Returns the places of a site by group: those of its own pages, then the reports, and those
/// further pages of reports whose headline names a group.
std::vector<Place> places_of(const std::vector<FoundReport>& reports,
                             const std::vector<Place>& own_pages);

/// Returns the links to all places, as HTML for a page in the folder `here` of the site: "" is the
/// front page, "comparison/count" a page of a report, "comparison/solvers/mads" one in such a page.
/// A word of the navigation leads to the first place of its group.
std::string navigation(const std::vector<Place>& places, const std::string& here);

/// Inserts the links into the pages of all places that have room for them. Throws OutputError.
void link_pages(const std::filesystem::path& site, const std::vector<Place>& places);

/// Replaces what stands between the comments <!-- mark --> and <!-- /mark --> of a written page. A
/// page without them, or one that is missing, stays as it is.
void put_at(const std::filesystem::path& page, const std::string& mark, const std::string& html);

}  // namespace ricochet::site
