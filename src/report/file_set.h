#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace ricochet::report {

/// The files of one report: name and text.
using FileSet = std::map<std::string, std::string>;

/// Puts the files into the folder, made if missing, with a manifest of them. What the manifest of
/// an earlier report names and this one has not is removed, if it is still as it was written. All
/// texts are on the disk before the first file is replaced. Throws InputError or OutputError, one
/// line with path and reason, and leaves everything as it was, where they do not get there.
void replace_files(const std::filesystem::path& folder, const FileSet& files);

}  // namespace ricochet::report
