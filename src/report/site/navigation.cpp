#include "src/report/site/navigation.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "embedded/navigation_template.h"
#include "src/report/filled_text.h"
#include "src/report/site/page_mark.h"
#include "src/report/text.h"

namespace ricochet::site {
namespace {

namespace fs = std::filesystem;

constexpr const char* mark = "navigation";

}  // namespace

std::string navigation(const std::vector<FoundReport>& reports, const std::string& here) {
  // The folders of the report, of its page and of the page in that.
  std::array<std::string, 3> own_place;
  std::string up;
  std::istringstream folders(here);
  for (std::string& folder : own_place) {
    if (std::getline(folders, folder, '/')) up += "../";
  }
  const auto& [own_folder, own_page, inner_page] = own_place;
  Json data = {{"up", up},
               {"front", here.empty()},
               {"own", Json()},
               {"own_page", own_page},
               {"inner_page", inner_page},
               {"reports", Json::array()},
               {"pages", Json::array()}};
  for (const FoundReport& report : reports) {
    const bool own = report.folder == own_folder;
    const std::string folder = report::escape_html(report.folder);
    const std::string label = report::escape_html(label_of(report));
    data["reports"].push_back(
        {{"folder", folder}, {"label", label}, {"here", own && own_page.empty()}});
    if (!own) continue;
    data["own"] = {{"folder", folder}, {"label", label}};
    for (const FoundPage& page : report.pages) {
      const std::string name = report::escape_html(page.folder);
      data["pages"].push_back({{"folder", folder},
                               {"page", name},
                               {"here", page.folder == own_page && inner_page.empty()},
                               {"around", page.folder == own_page && !inner_page.empty()}});
    }
  }
  data["has_pages"] = !data["pages"].empty();
  return report::filled(embedded::navigation_template, {&data});
}

void link_pages(const fs::path& site, const std::vector<FoundReport>& reports) {
  for (const FoundReport& report : reports) {
    put_at(site / report.folder / "index.html", mark, navigation(reports, report.folder));
    for (const FoundPage& page : report.pages) {
      const std::string name = report.folder + "/" + page.folder;
      put_at(site / name / "index.html", mark, navigation(reports, name));
      for (const std::string& inner : page.pages) {
        const std::string inner_name = name + "/" + inner;
        put_at(site / inner_name / "index.html", mark, navigation(reports, inner_name));
      }
    }
  }
}

}  // namespace ricochet::site
