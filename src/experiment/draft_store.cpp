#include "src/experiment/draft_store.h"

#include <SQLiteCpp/Transaction.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "embedded/schema.h"
#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/core/instance.h"
#include "src/experiment/run_rows.h"
#include "src/experiment/store_file.h"

namespace ricochet {

namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

[[noreturn]] void fail(const fs::path& file, int error) {
  const std::string message =
      fmt::format("{}: cannot be made: {}", file.string(), std::generic_category().message(error));
  if (is_failure_of_the_system(error)) throw OutputError(message);
  throw InputError(message);
}

}  // namespace

DraftStore::DraftStore(fs::path file, const CampaignDescription& description, Place where)
    : file_(std::move(file)), where_(where), interrupted_([this] { discard(); }) {
  static std::atomic<int> drafts = 0;
  check_absent();
  if (::access(folder_of(file_).c_str(), W_OK | X_OK) != 0) fail(file_, errno);
  {
    const Uninterrupted made_and_known;
    fs::path draft;
    int descriptor = -1;
    do {  // a killed process may have left a file with this name
      draft = folder_of(file_) / fmt::format(".ricochet.{}.{}.store.part", getpid(), drafts++);
      descriptor = ::open(draft.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor < 0 && errno == EEXIST);
    if (descriptor < 0) fail(file_, errno);
    ::close(descriptor);
    draft_ = std::move(draft);
  }
  try {
    database_ =
        std::make_unique<SQLite::Database>(fs::absolute(draft_).string(), SQLite::OPEN_READWRITE);
    // If this process dies, the draft is worthless, so it needs no journal on disk.
    database_->exec("PRAGMA journal_mode = MEMORY; PRAGMA foreign_keys = ON");
    SQLite::Transaction all(*database_);
    database_->exec(embedded::schema);
    database_->exec(fmt::format("PRAGMA user_version = {}", suite_version));
    add_description(*database_, description);
    all.commit();
  } catch (const SQLite::Exception& error) {
    discard();
    throw OutputError(fmt::format("{}: cannot be made: {}", file_.string(), error.what()));
  } catch (...) {
    discard();
    throw;
  }
}

DraftStore::~DraftStore() {
  discard();
}

void DraftStore::check_absent() const {
  std::error_code none;
  const bool exists = fs::exists(fs::symlink_status(file_, none));
  if (exists && where_ == Place::must_be_free) fail(file_, EEXIST);
  // SQLite would apply the changes left by an earlier store of this name to the new one.
  for (const char* ending : {"-wal", "-journal"}) {
    const std::string left = file_.string() + ending;
    if (!fs::exists(left, none)) continue;
    throw InputError(fmt::format(
        "{}: cannot be made: {} is left of another of this name: remove it, or give another name",
        file_.string(), left));
  }
}

void DraftStore::discard() {
  if (!draft_.empty()) ::unlink(draft_.c_str());
}

void DraftStore::place() {
  database_.reset();
  const Uninterrupted whole;
  if (where_ == Place::is_replaced) {
    check_absent();
    if (::rename(draft_.c_str(), file_.c_str()) != 0) fail(file_, errno);
  } else if (::link(draft_.c_str(), file_.c_str()) != 0) {
    if (errno != EPERM && errno != ENOTSUP && errno != ENOSYS) fail(file_, errno);
    check_absent();  // for a file system without links
    if (::rename(draft_.c_str(), file_.c_str()) != 0) fail(file_, errno);
  }
  discard();
  draft_.clear();
}

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

namespace {

constexpr std::size_t header_size = 32;
constexpr std::size_t frame_header_size = 24;
constexpr std::uint32_t log_magic = 0x377f0682;  // its last bit: checksums are of big-endian words

std::uint32_t word_at(std::span<const char> bytes, std::size_t place, bool big_endian = true) {
  std::uint32_t word = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t byte = big_endian ? k : 3 - k;
    word = word << 8U | static_cast<unsigned char>(bytes[place + byte]);
  }
  return word;
}

struct Checksum {
  bool big_endian;
  std::array<std::uint32_t, 2> sums = {};

  void add(std::span<const char> bytes) {
    for (std::size_t place = 0; place + 8 <= bytes.size(); place += 8) {
      sums[0] += word_at(bytes, place, big_endian) + sums[1];
      sums[1] += word_at(bytes, place + 4, big_endian) + sums[0];
    }
  }
  bool is_at(std::span<const char> bytes, std::size_t place) const {
    return sums[0] == word_at(bytes, place) && sums[1] == word_at(bytes, place + 4);
  }
};

[[noreturn]] void damaged(const std::filesystem::path& log) {
  throw Damage(log.filename().string() +
               " beside it is damaged; without that file its earlier runs can be read");
}

}  // namespace

void check_log(const std::filesystem::path& log) {
  std::ifstream in(log, std::ios::binary);
  std::array<char, header_size> header{};
  if (in.peek() == std::ifstream::traits_type::eof()) return;
  if (!in.read(header.data(), header.size())) return;  // torn: nothing was written after it
  if ((word_at(header, 0) & ~1U) != log_magic) damaged(log);
  Checksum sum{(word_at(header, 0) & 1U) != 0};
  const std::uint32_t page_size = word_at(header, 8);
  sum.add(std::span(header).first(24));
  constexpr std::uint32_t largest_page = 65536;
  if (!sum.is_at(header, 24) || page_size < 512 || page_size > largest_page) damaged(log);
  std::vector<char> frame(frame_header_size + page_size);
  const std::string salts(header.data() + 16, 8);
  bool is_torn = false;
  while (in.read(frame.data(), static_cast<std::streamsize>(frame.size())) &&
         std::string(frame.data() + 8, 8) == salts) {
    if (is_torn) damaged(log);
    sum.add(std::span(frame).first(8));
    sum.add(std::span(frame).subspan(frame_header_size));
    is_torn = !sum.is_at(frame, 16);
  }
}

}  // namespace ricochet
