#pragma once

#include <filesystem>

namespace ricochet::site {

/// Whether the folder is one of reports: its name is "reports", or it has a front page already.
/// Elsewhere a report stands alone, and nothing is written beside it.
bool is_site(const std::filesystem::path& folder);

/// Writes the front page of the reports in the folder, index.html, summary.md and data.json, and
/// links all their pages with each other and with it. Throws InputError or OutputError where the
/// folder cannot be written.
void write_site(const std::filesystem::path& folder);

/// Writes the front page above a report, if that folder is a site.
void write_site_above(const std::filesystem::path& report);

/// Draws all reports in a folder again, and its front page, into another or the same. Returns false
/// where there are none, and has done nothing.
bool redraw_site(const std::filesystem::path& from, const std::filesystem::path& folder);

}  // namespace ricochet::site
