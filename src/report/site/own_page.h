#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/report/page.h"
#include "src/report/site/place.h"

namespace ricochet::site {

/// A page of the site itself, drawn from the data of the reports.
struct OwnPage {
  Place place;
  report::Page page;
};

/// Writes the pages, except where a report has their folder. Returns the places of those written;
/// adds a line for each chart that could not be drawn. Throws OutputError.
std::vector<Place> write_own_pages(const std::filesystem::path& site,
                                   const std::vector<OwnPage>& pages,
                                   std::vector<std::string>& failures);

}  // namespace ricochet::site
