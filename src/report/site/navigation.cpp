#include "src/report/site/navigation.h"

#include <fmt/format.h>

#include <system_error>

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

/// Where a link leads, seen from a page: it is that page, the page is inside of it, or neither.
enum class Leads { here, around, away };

/// Links from one page of the site.
class LinksFrom {
 public:
  explicit LinksFrom(const std::string& here) : here_(here), up_(way_up(here)) {}

  std::string link(const std::string& folder, const std::string& label, Leads leads) const {
    const char* current = leads == Leads::here     ? " aria-current=\"page\""
                          : leads == Leads::around ? " aria-current=\"true\""
                                                   : "";
    return fmt::format("<a href=\"{}{}{}index.html\"{}>{}</a>", up_, report::escape_html(folder),
                       folder.empty() ? "" : "/", current, report::escape_html(label));
  }

  /// An item of a list: `around` unless it is this page.
  std::string item(const std::string& folder, const std::string& label, bool around) const {
    const Leads leads = folder == here_ ? Leads::here : around ? Leads::around : Leads::away;
    return "<li>" + link(folder, label, leads) + "</li>\n";
  }

 private:
  std::string here_, up_;
};

/// The way to a page inside a place, and the pages beside it.
std::string inside_of(const Place& own, const std::string& here, const LinksFrom& from) {
  std::string html;
  if (here != own.folder)
    html = "<p class=\"crumbs\">" + from.link(own.folder, own.label, Leads::away) + " › " +
           report::escape_html(here.substr(own.folder.size() + 1)) + "</p>\n";
  if (own.pages.empty()) return html;
  html += fmt::format("<details class=\"subpages\"><summary>{} pages of {}</summary>\n<ul>\n",
                      own.pages.size(), report::escape_html(own.label));
  for (const std::string& page : own.pages) html += from.item(own.folder + "/" + page, page, false);
  return html + "</ul>\n</details>\n";
}

}  // namespace

std::string navigation(const std::vector<Place>& places, const std::string& here) {
  const Place* own = holder_of(places, here);
  const LinksFrom from(here);
  std::string words = from.item("", "ricochet", false), group, beside;
  std::size_t number = 0;  // of places in the own group
  for (const Place& place : places) {
    const bool around = own != nullptr && own->group == place.group;
    if (place.group != group) words += from.item(place.folder, place.group, around);
    group = place.group;
    if (!around) continue;
    beside += from.item(place.folder, place.label, &place == own);
    ++number;
  }
  if (number > 1) beside = "<ul class=\"places\">\n" + beside + "</ul>\n";
  return "<nav class=\"site\" aria-label=\"Site\">\n<ul class=\"words\">\n" + words + "</ul>\n" +
         (number > 1 ? beside : "") + (own == nullptr ? "" : inside_of(*own, here, from)) +
         "</nav>\n";
}

void link_pages(const fs::path& site, const std::vector<Place>& places) {
  const auto link = [&](const std::string& folder) {
    put_at(site / folder / "index.html", mark, navigation(places, folder));
  };
  for (const Place& place : places) {
    link(place.folder);
    for (const std::string& page : place.pages) link(place.folder + "/" + page);
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
  // In reports/templates/sheet.html.
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
