#include "src/core/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

#include "ricochet/error.h"
#include "src/core/names.h"

namespace ricochet {

namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// The descriptor of a path in /proc/self/fd, the target of /dev/stdout and /dev/fd.
std::optional<int> descriptor_named(const fs::path& path) {
  std::error_code error;
  const fs::path descriptors = fs::canonical("/proc/self/fd", error);
  if (error || fs::canonical(folder_of(path), error) != descriptors) return std::nullopt;
  return number_of_text<int>(path.filename().native());
}

/// Returns an error number, 0 for none.
int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno != EINTR) return errno;
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// Closes the descriptor after any error; a full disk may be reported only now.
int close_after(int descriptor, int error) {
  const bool closed = ::close(descriptor) == 0;
  return error == 0 && !closed ? errno : error;
}

}  // namespace

bool is_failure_of_the_system(int error) {
  constexpr int of_the_system[] = {ENOSPC, EDQUOT, EIO,    EFBIG,   EPIPE, EBADF,
                                   ENOMEM, EMFILE, ENFILE, ENOBUFS, ENXIO, EAGAIN};
  return std::find(std::begin(of_the_system), std::end(of_the_system), error) !=
         std::end(of_the_system);
}

fs::path below(const fs::path& folder, const std::string& name) {
  fs::path place = folder / name;
  std::error_code none;
  const fs::file_status status = fs::symlink_status(place, none);
  if (fs::exists(status) && !fs::is_directory(status)) {
    throw InputError(fmt::format("{}: must be a folder, and no link to one", place.string()));
  }
  return place;
}

std::string text_of_file(const fs::path& file) {
  struct stat now {};
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (descriptor < 0 || ::fstat(descriptor, &now) != 0) {
    const std::string reason = std::generic_category().message(errno);
    if (descriptor >= 0) ::close(descriptor);
    throw InputError(fmt::format("{}: cannot be read: {}", file.string(), reason));
  }
  if (!S_ISREG(now.st_mode)) {
    ::close(descriptor);
    throw InputError(
        fmt::format("{}: must be a file, but is a folder, device or pipe", file.string()));
  }
  std::string text(static_cast<std::size_t>(now.st_size), '\0');
  std::size_t done = 0;
  ssize_t count = 0;
  while (done < text.size() &&
         (count = ::read(descriptor, text.data() + done, text.size() - done)) != 0) {
    if (count > 0) done += static_cast<std::size_t>(count);
    if (count < 0 && errno != EINTR) break;
  }
  const int error = close_after(descriptor, count < 0 ? errno : 0);
  if (error == 0) {
    text.resize(done);
    return text;
  }
  throw InputError(
      fmt::format("{}: cannot be read: {}", file.string(), std::generic_category().message(error)));
}

TextDraft::TextDraft(fs::path file, std::string_view text, SymbolicLinks links)
    : file_(std::move(file)), target_(file_), interrupted_([this] { discard(); }) {
  if (links == SymbolicLinks::refused) {
    std::error_code missing;
    const fs::file_status status = fs::symlink_status(file_, missing);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
      throw InputError(fmt::format("{}: cannot be written: it is a link, folder, device or pipe",
                                   file_.string()));
    }
    write_over(text);
    return;
  }
  constexpr int most_links = 40;  // the system's own limit
  std::error_code none;
  descriptor_ = descriptor_named(target_);
  for (int followed = 0; !descriptor_ && fs::is_symlink(target_, none); ++followed) {
    if (followed == most_links) fail(ELOOP);
    target_ = folder_of(target_) / fs::read_symlink(target_, none);
    descriptor_ = descriptor_named(target_);
  }
  struct stat now {};
  const bool there = !descriptor_ && ::stat(target_.c_str(), &now) == 0;
  if (!descriptor_ && !there && errno != ENOENT) fail(errno);
  if (there && S_ISDIR(now.st_mode)) fail(EISDIR);
  if (descriptor_ || (there && !S_ISREG(now.st_mode))) {
    text_ = text;
    return;
  }
  write_over(text);
}

void TextDraft::write_over(std::string_view text) {
  struct stat now {};
  const bool there = ::lstat(target_.c_str(), &now) == 0;
  if (!there && errno != ENOENT) fail(errno);
  // Root can write to every file; a read-only one is refused nevertheless.
  constexpr mode_t writable = S_IWUSR | S_IWGRP | S_IWOTH;
  if (there && ((now.st_mode & writable) == 0 || ::access(target_.c_str(), W_OK) != 0)) {
    fail(EACCES);
  }
  write_aside(text);
  if (!there) return;
  // The owner of another user's file cannot be kept, only the mode.
  if (::chown(draft_.c_str(), now.st_uid, now.st_gid) != 0) errno = 0;
  constexpr mode_t all_modes = 07777;
  if (::chmod(draft_.c_str(), now.st_mode & all_modes) != 0) {
    const int error = errno;
    discard();
    fail(error);
  }
}

TextDraft::~TextDraft() {
  discard();
}

void TextDraft::discard() const {
  if (!draft_.empty()) ::unlink(draft_.c_str());
}

void TextDraft::fail(int error) const {
  const std::string message = fmt::format("{}: cannot be written: {}", file_.string(),
                                          std::generic_category().message(error));
  if (is_failure_of_the_system(error)) throw OutputError(message);
  throw InputError(message);
}

void TextDraft::write_aside(std::string_view text) {
  static std::atomic<int> drafts = 0;
  int descriptor = -1;
  {
    const Uninterrupted made_and_known;
    do {  // a killed process may have left a file of this name
      draft_ = folder_of(target_) / fmt::format(".ricochet.{}.{}.part", getpid(), drafts++);
      descriptor = ::open(draft_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor < 0 && errno == EEXIST);
  }
  if (descriptor < 0) {
    draft_.clear();
    fail(errno);
  }
  int error = write_all(descriptor, text);
  if (error == 0 && ::fsync(descriptor) != 0 && errno != EINVAL) error = errno;
  error = close_after(descriptor, error);
  if (error == 0) return;
  discard();
  fail(error);
}

void TextDraft::write_through() const {
  if (descriptor_ == STDOUT_FILENO) std::fflush(stdout);
  const int descriptor = descriptor_ ? ::fcntl(*descriptor_, F_DUPFD_CLOEXEC, 0)
                                     : ::open(target_.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  if (descriptor < 0) fail(errno);
  const int error = close_after(descriptor, write_all(descriptor, text_));
  if (error != 0) fail(error);
}

void TextDraft::commit() {
  if (draft_.empty()) return write_through();
  const Uninterrupted whole;
  if (::rename(draft_.c_str(), target_.c_str()) != 0) fail(errno);
  draft_.clear();
}

void write_text_file(const fs::path& file, std::string_view text, SymbolicLinks links) {
  TextDraft(file, text, links).commit();
}

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
