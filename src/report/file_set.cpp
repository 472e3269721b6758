#include "src/report/file_set.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <vector>

#include "src/core/error.h"
#include "src/core/text_file.h"
#include "src/report/svg.h"

namespace ricochet::report {
namespace {

namespace fs = std::filesystem;

/// Makes the folder and what is missing above it; takes all of that back unless told to keep it.
class MadeFolder {
 public:
  explicit MadeFolder(const fs::path& folder) {
    for (fs::path path = fs::absolute(folder).lexically_normal();
         !path.empty() && !fs::exists(path); path = path.parent_path())
      made_.push_back(path);
    try {
      fs::create_directories(folder);
    } catch (const fs::filesystem_error&) {
      remove();
      throw;
    }
  }
  ~MadeFolder() { remove(); }
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;
  void keep() { made_.clear(); }

 private:
  void remove() {
    std::error_code ignored;
    for (const fs::path& path : made_) fs::remove(path, ignored);  // only if empty
  }
  std::vector<fs::path> made_;  ///< innermost first
};

/// A folder for drafts that vanishes with its content. Inside the report's folder, so that moving
/// a draft into place never crosses file systems.
class DraftFolder {
 public:
  explicit DraftFolder(const fs::path& folder)
      : path_(folder / fmt::format(".report.{}.part", getpid())) {
    fs::create_directory(path_);
  }
  ~DraftFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  DraftFolder(const DraftFolder&) = delete;
  DraftFolder& operator=(const DraftFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Whether an earlier report wrote the chart: a user's own drawing must survive.
bool is_our_chart(const fs::path& path) {
  if (path.extension() != ".svg" || !fs::is_regular_file(path)) return false;
  std::string start(std::string_view(svg_start).size(), '\0');
  std::ifstream(path, std::ios::binary)
      .read(start.data(), static_cast<std::streamsize>(start.size()));
  return start == svg_start;
}

/// Does the work; a failure of the file system becomes the user's error.
template <class Work>
void in_folder(const fs::path& folder, Work work) {
  try {
    MadeFolder made(folder);
    const DraftFolder draft(folder);
    work(made, draft);
  } catch (const fs::filesystem_error& error) {
    throw InputError(fmt::format("{}: the report cannot be written: {}", folder.string(),
                                 error.code().message()));
  }
}

}  // namespace

void require_writable(const fs::path& folder) {
  in_folder(folder, [](const MadeFolder&, const DraftFolder&) {});
}

void replace_files(const fs::path& folder, const FileSet& files) {
  in_folder(folder, [&](MadeFolder& made, const DraftFolder& draft) {
    for (const auto& [name, text] : files) {
      if (fs::is_directory(folder / name))
        throw InputError(
            fmt::format("{}: cannot be replaced: it is a folder", (folder / name).string()));
      write_text_file(draft.path() / name, text);
    }
    std::vector<fs::path> stale;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      if (is_our_chart(entry.path()) && !files.contains(entry.path().filename().string()))
        stale.push_back(entry.path());
    for (const auto& [name, text] : files) fs::rename(draft.path() / name, folder / name);
    for (const fs::path& path : stale) fs::remove(path);
    made.keep();
  });
}

}  // namespace ricochet::report
