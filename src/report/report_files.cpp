#include "src/report/report_files.h"

#include <fmt/format.h>

#include <deque>
#include <sstream>
#include <vector>

#include "src/core/files.h"
#include "src/core/instance.h"

namespace ricochet::report {

namespace {

namespace fs = std::filesystem;

/// A line for each file: a hash of its text, and its name.
constexpr const char* manifest_name = "manifest.txt";

std::string hash_of(const std::string& text) {
  return fmt::format("{:016x}", seed_of(text, "", 0, 0));
}

std::string manifest_of(const FileSet& files) {
  std::string lines;
  for (const auto& [name, text] : files) lines += fmt::format("{} {}\n", hash_of(text), name);
  return lines;
}

/// Empty if there is no such file.
std::string content_of(const fs::path& file) {
  std::error_code none;
  return fs::is_regular_file(file, none) ? text_of_file(file) : "";
}

/// Returns the files of an earlier report that are unchanged and that no new file replaces.
std::vector<fs::path> stale_files(const fs::path& folder, const FileSet& files) {
  std::vector<fs::path> stale;
  std::istringstream manifest(content_of(folder / manifest_name));
  for (std::string hash, name; manifest >> hash && std::getline(manifest >> std::ws, name);) {
    const fs::path path = folder / name;
    const bool ours = fs::path(name).filename() == name &&
                      fs::is_regular_file(fs::symlink_status(path)) &&
                      hash_of(content_of(path)) == hash;
    if (ours && !files.contains(name)) stale.push_back(path);
  }
  return stale;
}

/// Writes all texts to the disk.
std::deque<TextDraft> drafts_of(const fs::path& folder, const FileSet& files) {
  std::deque<TextDraft> drafts;
  for (const auto& [name, text] : files)
    drafts.emplace_back(folder / name, text, SymbolicLinks::refused);
  return drafts;
}

}  // namespace

void add_files(const fs::path& folder, const FileSet& files) {
  const MadeFolder made(folder);
  std::deque<TextDraft> drafts = drafts_of(folder, files);
  const Uninterrupted whole;
  for (TextDraft& draft : drafts) draft.commit();
}

void replace_files(const fs::path& folder, const FileSet& files) {
  const MadeFolder made(folder);
  std::deque<TextDraft> drafts = drafts_of(folder, files);
  TextDraft manifest(folder / manifest_name, manifest_of(files), SymbolicLinks::refused);
  const std::vector<fs::path> stale = stale_files(folder, files);
  const Uninterrupted whole;
  for (TextDraft& draft : drafts) draft.commit();
  std::error_code ignored;
  for (const fs::path& path : stale) fs::remove(path, ignored);
  manifest.commit();
}

}  // namespace ricochet::report
