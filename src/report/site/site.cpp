#include "src/report/site/site.h"

#include <stdexcept>
#include <system_error>
#include <utility>

#include "ricochet/error.h"
#include "src/core/text_file.h"
#include "src/report/file_set.h"
#include "src/report/report.h"
#include "src/report/site/cite_page.h"
#include "src/report/site/docs_pages.h"
#include "src/report/site/front_page.h"
#include "src/report/site/live_page.h"
#include "src/report/site/machine_page.h"
#include "src/report/site/navigation.h"
#include "src/report/site/page_mark.h"
#include "src/report/site/paper_algorithm.h"
#include "src/report/text.h"

namespace ricochet::site {
namespace {

namespace fs = std::filesystem;

constexpr const char* data_file = "data.json";
constexpr const char* live_folder = "live";  ///< of the machine that runs in a browser

/// Removes dots and a trailing slash, so that the path has a name and a parent.
fs::path plain(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

/// Puts the answer about the paper's algorithm, which a comparison gives, into the reports about
/// it.
void tell_of_paper_algorithm(const fs::path& folder, const std::vector<FoundReport>& reports,
                             const Front& front) {
  if (!front.comparison) return;
  const auto answer = paper_algorithm(*largest_comparison(reports));
  if (!answer) return;
  const std::string html = "<p>" + report::escape_html(answer->text) + "</p>\n";
  for (const FoundReport& report : reports) {
    if (report.kind.name == "fireworks") {
      put_at(folder / report.folder / "index.html", "comparison", html);
    }
  }
}

/// Writes the pages that are no report. Returns the places of all pages.
std::vector<Place> written_places(const fs::path& folder, const std::vector<FoundReport>& reports,
                                  const Front& front, std::vector<std::string>& failures) {
  std::vector<OwnPage> pages;
  if (front.machines) pages.push_back(machine_page(*front.machines, reports));
  pages.push_back(cite_page(reports, front.comparison ? largest_comparison(reports) : nullptr));
  std::vector<Place> own = write_own_pages(folder, pages, failures);
  own.push_back({"Machine", "Live machine", live_folder});
  own.push_back(write_docs_pages(folder, reports));
  return places_of(reports, own);
}

struct WrittenSite {
  std::vector<std::string> undrawn;                         ///< a line for each chart
  std::vector<std::pair<std::string, std::string>> unread;  ///< see Front
};

WrittenSite written_site(const fs::path& folder) {
  const std::vector<FoundReport> reports = found_reports(folder);
  Front front = front_of(reports);
  std::vector<std::string> failures;
  const std::vector<Place> places = written_places(folder, reports, front, failures);
  FrontPage page = front_page(front, navigation(places, ""));
  report::replace_files(folder, page.files);
  report::add_files(below(folder, live_folder),
                    {{"index.html", live_page(navigation(places, live_folder))}});
  link_pages(folder, places, reports);
  tell_of_paper_algorithm(folder, reports, front);
  failures.insert(failures.end(), page.failures.begin(), page.failures.end());
  return {std::move(failures), std::move(front.unread)};
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

std::vector<std::string> write_site(const fs::path& folder) {
  return written_site(folder).undrawn;
}

std::vector<std::string> write_site_above(const fs::path& report) {
  const fs::path above = plain(report).parent_path();
  return is_site(above) ? write_site(above) : std::vector<std::string>();
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
    // The front page says that it must be made anew.
    if (fs::equivalent(from, folder, none)) continue;
    ricochet::report::add_files(below(folder, report),
                                {{data_file, text_of_file(from / report / data_file)}});
  }
  const WrittenSite front = written_site(folder);
  for (const auto& [report, reason] : front.unread) {
    failures.push_back((from / report / data_file).string() +
                       ": must be the data of a report: " + reason);
  }
  for (const std::string& line : front.undrawn) {
    failures.push_back((folder / data_file).string() + ": " + line);
  }
  return failures;
}

}  // namespace ricochet::site
