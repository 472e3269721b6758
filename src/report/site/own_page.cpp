#include "src/report/site/own_page.h"

#include <system_error>

#include "src/core/text_file.h"

namespace ricochet::site {

std::vector<Place> write_own_pages(const std::filesystem::path& site,
                                   const std::vector<OwnPage>& pages,
                                   std::vector<std::string>& failures) {
  std::vector<Place> places;
  std::error_code none;
  for (const OwnPage& own : pages) {
    const std::filesystem::path folder = below(site, own.place.folder);
    if (std::filesystem::exists(folder / "data.json", none)) continue;
    for (const std::string& line : report::write_page(own.page, folder)) {
      failures.push_back(own.place.folder + ": " + line);
    }
    places.push_back(own.place);
  }
  return places;
}

}  // namespace ricochet::site
