#include "src/benchmark/experiment/store/writer_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "ricochet/error.h"

namespace ricochet {
namespace {

std::filesystem::path lock_of(const std::filesystem::path& file) {
  return std::filesystem::canonical(file).string() + "-lock";
}

}  // namespace

WriterLock::WriterLock(const std::filesystem::path& file) : lock_(lock_of(file)) {
  for (;;) {
    descriptor_ =
        ::open(lock_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      throw InputError(fmt::format("{}: cannot be written to: {}: {}", file.string(),
                                   lock_.string(), std::generic_category().message(errno)));
    }
    // If the file system has no locks, go on without one.
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(descriptor_);
      throw InputError(fmt::format(
          "{}: another ricochet adds runs to it: wait until it ends, or give another file",
          file.string()));
    }
    if (is_there()) return;
    ::close(descriptor_);  // its previous owner removed it meanwhile
  }
}

std::unique_ptr<WriterLock> WriterLock::taken_if_free(const std::filesystem::path& file) {
  try {
    return std::make_unique<WriterLock>(file);
  } catch (const InputError&) {
    return nullptr;
  }
}

bool WriterLock::is_taken(const std::filesystem::path& file) {
  const int descriptor =
      ::open(lock_of(file).c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool taken = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return taken;
}

WriterLock::~WriterLock() {
  ::unlink(lock_.c_str());
  ::flock(descriptor_, LOCK_UN);  // also for forked processes
  ::close(descriptor_);
}

bool WriterLock::is_there() const {
  struct stat ours {};
  struct stat there {};
  return ::fstat(descriptor_, &ours) == 0 && ::stat(lock_.c_str(), &there) == 0 &&
         ours.st_dev == there.st_dev && ours.st_ino == there.st_ino;
}

}  // namespace ricochet
