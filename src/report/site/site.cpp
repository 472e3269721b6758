#include "src/report/site/site.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "embedded/docs_look.h"
#include "embedded/docs_page.h"
#include "embedded/documents.h"
#include "embedded/machine_sketch.h"
#include "embedded/search_script.h"
#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/report/drawing.h"
#include "src/report/markdown_html.h"
#include "src/report/report.h"
#include "src/report/report_files.h"
#include "src/report/site/front.h"
#include "src/report/site/machine_page.h"
#include "src/report/site/navigation.h"
#include "src/report/text.h"

namespace ricochet::site {

namespace {

namespace fs = std::filesystem;

constexpr const char* data_file = "data.json";
constexpr const char* cite_folder = "cite";
constexpr const char* live_folder = "live";  ///< of the machine that runs in a browser

/// Removes dots and a trailing slash, so that the path has a name and a parent.
fs::path plain(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

/// Writes the pages that are no report. Returns the places of all pages.
std::vector<Place> written_places(const fs::path& folder, const std::vector<FoundReport>& reports,
                                  const report::Results& site, std::vector<std::string>& failures) {
  std::vector<Place> own;
  const Place machine = machine_place();
  std::error_code none;
  if (!fs::exists(below(folder, machine.folder) / data_file, none)) {  // no report is there
    OwnFiles page = machine_page(site);
    report::replace_files(below(folder, machine.folder), page.files);
    for (const std::string& line : page.failures) failures.push_back(machine.folder + ": " + line);
    own.push_back(machine);
  }
  const OwnFiles cite = cite_page(site);
  report::replace_files(below(folder, cite_folder), cite.files);
  own.push_back({"Data", "Cite and repeat", cite_folder});
  own.push_back({"Machine", "Live machine", live_folder});
  own.push_back(write_docs_pages(folder, reports));
  return places_of(reports, own);
}

constexpr const char* alone =
    "The pages have only what this machine has computed: the committed reference, which would "
    "stand "
    "for the rest, is in ricochet's source tree, and this program is not.";

std::vector<std::string> written_site(const fs::path& folder, bool is_alone = false) {
  const std::vector<FoundReport> reports = found_reports(folder);
  report::Results site = site_results(reports);
  if (is_alone) site.set("origins", alone);
  std::vector<std::string> failures;
  const std::vector<Place> places = written_places(folder, reports, site, failures);
  OwnFiles front = front_page(site);
  report::replace_files(folder, front.files);
  report::add_files(below(folder, live_folder),
                    {{"index.html", live_page(navigation(places, live_folder))}});
  put_at(folder / "index.html", "navigation", navigation(places, ""));
  link_pages(folder, places);
  failures.insert(failures.end(), front.failures.begin(), front.failures.end());
  return failures;
}

}  // namespace

bool is_site(const fs::path& folder) {
  if (plain(folder).filename() == "reports") return true;
  std::error_code none;
  if (!fs::exists(folder / data_file, none)) return false;
  const Json data = Json::parse(text_of_file(folder / data_file), nullptr, false);
  const auto kind = data.is_object() ? data.find("report") : data.end();
  return kind != data.end() && *kind == "site";
}

std::vector<std::string> write_site(const fs::path& folder,
                                    const std::optional<fs::path>& reference) {
  std::vector<std::string> failures;
  if (reference) failures = complete(folder, *reference);
  const auto own = written_site(folder, !reference);
  failures.insert(failures.end(), own.begin(), own.end());
  return failures;
}

std::vector<std::string> write_site_above(const fs::path& report,
                                          const std::optional<fs::path>& reference) {
  const fs::path above = plain(report).parent_path();
  return is_site(above) ? write_site(above, reference) : std::vector<std::string>();
}

std::optional<std::vector<std::string>> redraw_site(const fs::path& from, const fs::path& folder) {
  std::error_code none;
  if (fs::exists(from / data_file, none) && !is_site(from)) return std::nullopt;
  const std::vector<std::string> reports = folders_of_data(from);
  if (reports.empty()) return std::nullopt;
  std::vector<std::string> failures;
  for (const std::string& report : reports) {
    try {
      const auto written = report::redraw_report(from / report, below(folder, report));
      failures.insert(failures.end(), written.failures.begin(), written.failures.end());
      continue;
    } catch (const std::logic_error& error) {
      failures.emplace_back(error.what());
    } catch (const InputError& error) {
      failures.emplace_back(error.what());
    }
    // The front page says that it must be written again.
    if (fs::equivalent(from, folder, none)) continue;
    ricochet::report::add_files(below(folder, report),
                                {{data_file, text_of_file(from / report / data_file)}});
  }
  for (const std::string& line : written_site(folder)) {
    failures.push_back((folder / data_file).string() + ": " + line);
  }
  return failures;
}

namespace {

/// The sketch of the machine, in docs/.
constexpr const char* drawing = "machine.svg";

/// What the search looks through: a heading of a page, and the text below it.
struct SearchEntry {
  std::string page, heading;
  std::string address;  ///< of the heading, seen from the page of the search
  std::string text;
};
RICOCHET_FIELDS(SearchEntry, page, heading, address, text);

/// Leads links of a document in docs/NAME to pages of the site.
class Links {
 public:
  explicit Links(const fs::path& site) : site_(site) {}

  std::string operator()(const std::string& link) const {
    const std::size_t hash = std::min(link.find('#'), link.size());
    const std::string file = link.substr(0, hash), anchor = link.substr(hash);
    if (file.empty() || file.starts_with("https://")) return link;
    const fs::path path = (fs::path("docs") / file).lexically_normal();
    if (path.parent_path() == "docs" && path.extension() == ".md") {
      const std::string name = path.stem().string();
      const bool known = std::ranges::any_of(
          embedded::documents, [&](const auto& document) { return document.first == name; });
      return known ? "../" + name + "/index.html" + anchor : "";
    }
    if (path == fs::path("docs") / drawing) return std::string("../") + drawing;
    return to_report(path);
  }

 private:
  /// NOTE: a page's anchors are not those of its summary; the link leads to its beginning.
  std::string to_report(const fs::path& path) const {
    const fs::path inside = path.lexically_relative("reports/reference");
    if (inside.empty() || *inside.begin() == "..") return "";
    const fs::path target =
        inside.extension() == ".md" ? inside.parent_path() / "index.html" : inside;
    std::error_code none;
    return fs::exists(site_ / target, none) ? "../../" + target.generic_string() : "";
  }

  fs::path site_;
};

/// What a document needs beside the look of all pages: long words break.
constexpr const char* document_look =
    "main li { max-width: 46rem; }\n"
    "main img { max-width: min(100%, 40rem); height: auto; background: #fff; }\n"
    "main p, main li, main h2, main h3 { overflow-wrap: anywhere; }\n"
    "@media screen and (max-width: 48rem) { .contents { display: none; } }\n";

/// Adds the headings of a page that has a summary, and what stands below each but for tables.
void add_page(const fs::path& site, const std::string& folder, const std::string& finding,
              std::vector<SearchEntry>& search) {
  const fs::path page = below(site, folder);
  std::error_code none;
  if (!fs::exists(page / "summary.md", none)) return;
  const report::HtmlPage document = report::html_page(
      text_of_file(page / "summary.md"), {.target = [](const std::string&) { return ""; }});
  const std::string address = "../" + folder + "/index.html";
  for (const report::PagePart& part : document.parts) {
    if (&part == &document.parts.front()) {
      search.push_back({document.title, part.heading, address, finding + " " + part.prose});
    } else if (!part.anchor.empty()) {
      search.push_back({document.title, part.heading, address + "#" + part.anchor, part.prose});
    } else {
      search.back().text += part.heading + " " + part.prose;
    }
  }
}

}  // namespace

Place write_docs_pages(const fs::path& site, const std::vector<FoundReport>& reports) {
  const fs::path folder = below(site, docs_folder);
  Place place{"Data", "Docs and search", docs_folder};
  std::vector<SearchEntry> search;
  std::string list;
  for (const auto& [name, markdown] : embedded::documents) {
    const report::HtmlPage page =
        report::html_page(markdown, {.target = Links(site), .look = document_look});
    for (const report::PagePart& part : page.parts)
      search.push_back(
          {page.title, part.heading, std::string(name) + "/index.html#" + part.anchor, part.text});
    report::replace_files(below(folder, name), {{"index.html", page.html}});
    list += fmt::format("<li><a href=\"{}/index.html\">{}</a></li>\n", name,
                        report::escape_html(page.title));
    place.pages.emplace_back(name);
  }
  for (const std::string& own : {machine_place().folder, std::string(cite_folder)})
    add_page(site, own, "", search);
  for (const FoundReport& report : reports) {
    const auto finding = [](const auto& one) { return one.headline ? one.headline->finding : ""; };
    add_page(site, report.folder, finding(report), search);
    for (const FoundPage& page : report.pages)
      add_page(site, report.folder + "/" + page.folder, finding(page), search);
  }
  const std::string body = report::with_slots(
      embedded::docs_page,
      {{"documents", list}, {"search", report::json_in_script(Json(search).dump())}});
  report::replace_files(folder,
                        {{"index.html", report::sheet_html(place.label, body, embedded::docs_look,
                                                           {embedded::search_script})},
                         {drawing, embedded::machine_sketch}});
  return place;
}

namespace {

/// Throws InputError unless the folder may be overwritten.
void require_own(const fs::path& from, const fs::path& folder) {
  std::error_code none;
  if (!fs::exists(folder, none)) return;
  if (fs::equivalent(from, folder, none)) {
    throw InputError(folder.string() + ": must be another folder than that of the reports");
  }
  const bool ours = fs::exists(folder / "data.json", none) && is_site(folder);
  if (!ours && !fs::is_empty(folder, none)) {
    throw InputError(folder.string() + ": must be new, empty or an earlier site");
  }
}

}  // namespace

Publication publish_site(const fs::path& from, const fs::path& folder) {
  require_own(from, folder);
  auto failures = redraw_site(from, folder);
  if (!failures) {
    throw InputError(from.string() + ": must be a folder of reports; it has none");
  }
  write_text_file(folder / ".nojekyll", "",
                  SymbolicLinks::refused);  // so that hosts that run Jekyll serve it as it is
  Publication written;
  written.failures = std::move(*failures);
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    written.bytes += entry.file_size();
    if (entry.path().filename() == "index.html") ++written.pages;
  }
  return written;
}

}  // namespace ricochet::site
