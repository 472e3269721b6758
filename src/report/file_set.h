#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace ricochet::report {

/// The files of one report: name and text.
using FileSet = std::map<std::string, std::string>;

/// Throws the InputError of replace_files, before any work is done for them, where the folder
/// cannot be written. Leaves no trace.
void require_writable(const std::filesystem::path& folder);

/// Puts the files into the folder, made if missing, and removes the charts of an earlier report
/// that have no successor. All texts are on the disk before the first file is replaced. Throws
/// InputError, one line with path and reason, and leaves everything as it was, where they do not
/// get there.
void replace_files(const std::filesystem::path& folder, const FileSet& files);

}  // namespace ricochet::report
