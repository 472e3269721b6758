#pragma once

#include <filesystem>

#include "src/report/site/place.h"

namespace ricochet::site {

/// Folder of the documents in a site.
inline constexpr const char* docs_folder = "docs";

/// Writes the documents of docs/ as pages, and a page that lists and searches them, with what the
/// reports found. Links to reports lead to their pages, if they are there; a link to what the site
/// does not have becomes plain text. Returns their place. Throws OutputError.
Place write_docs_pages(const std::filesystem::path& site, const std::vector<FoundReport>& reports);

}  // namespace ricochet::site
