#include "src/benchmark/experiment/store/draft_store.h"

#include <SQLiteCpp/Transaction.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include "embedded/schema.h"
#include "ricochet/error.h"
#include "src/benchmark/experiment/store/description_rows.h"
#include "src/core/suite_version.h"
#include "src/core/text_file.h"

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

}  // namespace ricochet
