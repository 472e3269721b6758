#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ricochet::site {

/// Returns true if the folder contains reports: its name is "reports", or it already has a front
/// page. In other folders a report stands alone, and no further file is written.
bool is_site(const std::filesystem::path& folder);

/// Writes the front page of the reports in the folder, index.html, summary.md and data.json, the
/// page of a live machine, live/index.html, and links all pages with each other. Returns a line for
/// each of its charts that could not be drawn. Throws InputError or OutputError if the folder
/// cannot be written.
std::vector<std::string> write_site(const std::filesystem::path& folder);

/// Writes the front page of the folder above a report, if it is a site. Returns the same.
std::vector<std::string> write_site_above(const std::filesystem::path& report);

/// Draws all reports in a folder and its front page again, into another folder or the same. Returns
/// a line for each chart that could not be drawn, and for each report whose data are damaged or of
/// another version, which begins with the file; nothing if there are no reports.
std::optional<std::vector<std::string>> redraw_site(const std::filesystem::path& from,
                                                    const std::filesystem::path& folder);

}  // namespace ricochet::site
