#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace ricochet::report {

/// The files of one report: name and text.
using FileSet = std::map<std::string, std::string>;

/// Writes the files into the folder, creates it if needed, and leaves all other files unchanged.
/// Throws as replace_files.
void add_files(const std::filesystem::path& folder, const FileSet& files);

/// Writes the files into the folder, creates it if needed, and adds a manifest of them. Files that
/// only the manifest of an earlier report names are removed if they are unchanged. All texts are on
/// the disk before the first file is replaced. If that fails, throws InputError or OutputError, one
/// line with path and reason, and leaves everything as it was.
void replace_files(const std::filesystem::path& folder, const FileSet& files);

}  // namespace ricochet::report
