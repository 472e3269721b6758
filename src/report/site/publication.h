#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ricochet::site {

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
