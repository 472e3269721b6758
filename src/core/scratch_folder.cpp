#include "src/core/scratch_folder.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "src/core/text_file.h"

namespace ricochet {
namespace {

namespace fs = std::filesystem;

fs::path made() {
  std::error_code error;
  const fs::path below = fs::temp_directory_path(error);
  std::string name = (below / "ricochet-XXXXXX").string();
  if (error || ::mkdtemp(name.data()) == nullptr) {
    const std::error_code reason = error ? error : std::error_code(errno, std::generic_category());
    throw OutputError(
        fmt::format("{}: a temporary folder cannot be made: {}", below.string(), reason.message()));
  }
  return name;
}

}  // namespace

ScratchFolder::ScratchFolder() : path_(made()), interrupted_([this] { remove(); }) {}

ScratchFolder::~ScratchFolder() {
  remove();
}

void ScratchFolder::remove() const {
  std::error_code none;
  fs::remove_all(path_, none);
}

}  // namespace ricochet
