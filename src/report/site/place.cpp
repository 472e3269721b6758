#include "src/report/site/place.h"

#include <utility>

namespace ricochet::site {

std::vector<Place> places_of(const std::vector<FoundReport>& reports,
                             const std::vector<Place>& own_pages) {
  std::vector<Place> all = own_pages;
  for (const FoundReport& report : reports) {
    Place place{report.kind.group, label_of(report), report.folder};
    for (const FoundPage& page : report.pages) place.pages.push_back(page.folder);
    all.push_back(std::move(place));
    for (const FoundPage& page : report.pages) {
      if (!page.headline || page.headline->group.empty()) continue;
      all.push_back(
          {page.headline->group, page.headline->label, report.folder + "/" + page.folder});
    }
  }
  std::vector<Place> sorted;
  for (const char* group : groups) {
    for (const Place& place : all) {
      if (place.group == group) sorted.push_back(place);
    }
  }
  return sorted;
}

}  // namespace ricochet::site
