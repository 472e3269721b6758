#pragma once

#include <string>
#include <vector>

#include "src/report/site/found_report.h"

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

}  // namespace ricochet::site
