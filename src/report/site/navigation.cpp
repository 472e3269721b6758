#include "src/report/site/navigation.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "embedded/navigation_template.h"
#include "src/core/files.h"
#include "src/report/text.h"

namespace ricochet::site {

namespace {

namespace fs = std::filesystem;

constexpr const char* mark = "navigation";

/// The place that holds the page of a folder: the innermost one; null for the front page.
const Place* holder_of(const std::vector<Place>& places, const std::string& here) {
  const Place* holder = nullptr;
  for (const Place& place : places) {
    const bool holds = here == place.folder || here.starts_with(place.folder + "/");
    if (holds && (holder == nullptr || place.folder.size() > holder->folder.size())) {
      holder = &place;
    }
  }
  return holder;
}

std::string way_up(const std::string& here) {
  if (here.empty()) return "";
  std::string up = "../";
  for (const char c : here) {
    if (c == '/') up += "../";
  }
  return up;
}

/// The words, of which each leads to the first place of its group.
Json words_of(const std::vector<Place>& places, const Place* own, const std::string& here) {
  Json words = Json::array();
  std::string last;
  for (const Place& place : places) {
    if (place.group == last) continue;
    last = place.group;
    const bool around = own != nullptr && own->group == place.group;
    words.push_back({{"word", report::escape_html(place.group)},
                     {"folder", report::escape_html(place.folder)},
                     {"here", here == place.folder},
                     {"around", around && here != place.folder}});
  }
  return words;
}

/// The pages inside a place, with the way to the one shown.
void add_pages(const Place& own, const std::string& here, Json& data) {
  const std::string inside = here == own.folder ? "" : here.substr(own.folder.size() + 1);
  const std::size_t slash = std::min(inside.find('/'), inside.size());
  const std::string page = inside.substr(0, slash);
  const std::string inner = slash < inside.size() ? inside.substr(slash + 1) : "";
  data["own"] = {{"folder", report::escape_html(own.folder)},
                 {"label", report::escape_html(own.label)}};
  data["own_page"] = report::escape_html(page);
  data["inner_page"] = report::escape_html(inner);
  for (const std::string& one : own.pages) {
    data["pages"].push_back({{"folder", report::escape_html(own.folder)},
                             {"page", report::escape_html(one)},
                             {"here", one == page && inner.empty()},
                             {"around", one == page && !inner.empty()}});
  }
}

}  // namespace

std::string navigation(const std::vector<Place>& places, const std::string& here) {
  const Place* own = holder_of(places, here);
  Json data = {
      {"up", way_up(here)},      {"front", here.empty()}, {"words", words_of(places, own, here)},
      {"own", Json()},           {"own_page", ""},        {"inner_page", ""},
      {"places", Json::array()}, {"pages", Json::array()}};
  if (own != nullptr) {
    for (const Place& place : places) {
      if (place.group != own->group) continue;
      data["places"].push_back({{"folder", report::escape_html(place.folder)},
                                {"label", report::escape_html(place.label)},
                                {"here", here == place.folder},
                                {"around", &place == own && here != place.folder}});
    }
    add_pages(*own, here, data);
  }
  data["has_places"] = data["places"].size() > 1;
  data["has_pages"] = !data["pages"].empty();
  data["page_count"] = data["pages"].size();
  return report::filled(embedded::navigation_template, {&data});
}

void link_pages(const fs::path& site, const std::vector<Place>& places,
                const std::vector<FoundReport>& reports) {
  const auto link = [&](const std::string& folder) {
    put_at(site / folder / "index.html", mark, navigation(places, folder));
  };
  for (const Place& place : places) {
    link(place.folder);
    for (const std::string& page : place.pages) link(place.folder + "/" + page);
  }
  for (const FoundReport& report : reports) {
    for (const FoundPage& page : report.pages) {
      for (const std::string& inner : page.pages) {
        link(report.folder + "/" + page.folder + "/" + inner);
      }
    }
  }
}

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

void put_at(const std::filesystem::path& page, const std::string& mark, const std::string& html) {
  // In reports/templates/page.mustache.
  const std::string opening = "<!-- " + mark + " -->", closing = "<!-- /" + mark + " -->";
  std::error_code none;
  if (!std::filesystem::exists(page, none)) return;
  const std::string text = text_of_file(page);
  const std::size_t start = text.find(opening), end = text.find(closing);
  if (start == std::string::npos || end == std::string::npos || end < start) return;
  const std::size_t after = start + opening.size();
  const std::string changed = text.substr(0, after) + "\n" + html + text.substr(end);
  if (changed != text) write_text_file(page, changed, SymbolicLinks::refused);
}

}  // namespace ricochet::site
