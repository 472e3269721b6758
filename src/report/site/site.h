#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/report/site/navigation.h"

namespace ricochet::site {

/// Returns true if the folder contains reports: its name is "reports", or it already has a front
/// page. In other folders a report stands alone, and no further file is written.
bool is_site(const std::filesystem::path& folder);

/// Writes the front page of the reports in the folder, index.html, summary.md and data.json, the
/// page of a live machine, live/index.html, and links all pages with each other. Returns a line for
/// each of its charts that could not be drawn. With a reference the site is whole, see complete();
/// without one it says so. Throws InputError or OutputError if the folder cannot be written.
std::vector<std::string> write_site(const std::filesystem::path& folder,
                                    const std::optional<std::filesystem::path>& reference);

/// Writes the front page of the folder above a report, if it is a site. Returns the same.
std::vector<std::string> write_site_above(const std::filesystem::path& report,
                                          const std::optional<std::filesystem::path>& reference);

/// Draws all reports in a folder and its front page again, into another folder or the same. Returns
/// a line for each chart that could not be drawn, and for each report whose data are damaged or of
/// another version, which begins with the file; nothing if there are no reports.
std::optional<std::vector<std::string>> redraw_site(const std::filesystem::path& from,
                                                    const std::filesystem::path& folder);

/// Folder of the documents in a site.
inline constexpr const char* docs_folder = "docs";

/// Writes the documents of docs/ as pages, and a page that lists and searches them, with what the
/// reports found. Links to reports lead to their pages, if they are there; a link to what the site
/// does not have becomes plain text. Returns their place. Throws OutputError.
Place write_docs_pages(const std::filesystem::path& site, const std::vector<FoundReport>& reports);

/// A site written for a static host.
struct Publication {
  std::size_t pages = 0;
  std::uintmax_t bytes = 0;                ///< of all files
  std::vector<std::string> failures = {};  ///< a line for each thing that could not be drawn
};

/// Writes the whole site of a folder of reports into another folder, which must be new, empty or an
/// earlier such site: the reports with their data, the front page, the documents, and the machine
/// that runs in a browser. Throws InputError for a folder without reports or one that holds
/// something else; OutputError.
Publication publish_site(const std::filesystem::path& from, const std::filesystem::path& folder);

}  // namespace ricochet::site
