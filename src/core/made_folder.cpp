#include "src/core/made_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "ricochet/error.h"
#include "src/core/text_file.h"

namespace ricochet {

namespace fs = std::filesystem;

MadeFolder::MadeFolder(const fs::path& folder) : interrupted_([this] { take_back(); }) {
  std::error_code error;
  {
    const Uninterrupted made_and_known;
    for (fs::path path = fs::absolute(folder).lexically_normal();
         !fs::exists(path, error) && !error; path = path.parent_path())
      made_.push_back(path);
    if (!error) fs::create_directories(folder, error);
  }
  if (!error && ::access(folder.c_str(), W_OK | X_OK) != 0)
    error = std::error_code(errno, std::generic_category());
  if (!error) return;
  take_back();
  const std::string message =
      fmt::format("{}: nothing can be written there: {}", folder.string(), error.message());
  if (is_failure_of_the_system(error.value())) throw OutputError(message);
  throw InputError(message);
}

MadeFolder::~MadeFolder() {
  take_back();
}

void MadeFolder::take_back() const {
  for (const fs::path& path : made_) ::rmdir(path.c_str());  // only if empty
}

}  // namespace ricochet
