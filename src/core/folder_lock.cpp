#include "src/core/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "ricochet/error.h"

namespace ricochet {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : made_(folder), descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  // No lock is held if the file system has none or the folder cannot be read.
  if (descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) {
    return;
  }
  ::close(descriptor_);
  throw InputError(fmt::format(
      "{}: another ricochet is at work there: wait until it ends, or give another folder",
      folder.string()));
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace ricochet
