#include "src/report/site/publication.h"

#include <system_error>
#include <utility>

#include "ricochet/error.h"
#include "src/core/text_file.h"
#include "src/report/site/site.h"

namespace ricochet::site {
namespace {

namespace fs = std::filesystem;

/// Throws InputError unless the folder may be overwritten.
void require_own(const fs::path& from, const fs::path& folder) {
  std::error_code none;
  if (!fs::exists(folder, none)) return;
  if (fs::equivalent(from, folder, none)) {
    throw InputError(folder.string() + ": must be another folder than that of the reports");
  }
  const bool ours = fs::exists(folder / "data.json", none) && is_site(folder);
  if (!ours && !fs::is_empty(folder, none)) {
    throw InputError(folder.string() + ": must be new, empty or an earlier site");
  }
}

}  // namespace

Publication publish_site(const fs::path& from, const fs::path& folder) {
  require_own(from, folder);
  auto failures = redraw_site(from, folder);
  if (!failures) {
    throw InputError(from.string() + ": must be a folder of reports; it has none");
  }
  write_text_file(folder / ".nojekyll", "",
                  SymbolicLinks::refused);  // so that hosts that run Jekyll serve it as it is
  Publication written;
  written.failures = std::move(*failures);
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    written.bytes += entry.file_size();
    if (entry.path().filename() == "index.html") ++written.pages;
  }
  return written;
}

}  // namespace ricochet::site
