#include "src/experiment/store_file.h"

#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>

#include "embedded/schema.h"
#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/core/instance.h"
#include "src/core/progress.h"
#include "src/experiment/archive.h"
#include "src/experiment/draft_store.h"
#include "src/experiment/run_rows.h"
#include "src/experiment/store.h"

namespace ricochet {

std::unique_ptr<SQLite::Database> guarded(std::unique_ptr<SQLite::Database> database) {
  constexpr int longest_value = 100'000'000;  // bytes, of a text or of points
  sqlite3* const handle = database->getHandle();
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, longest_value);
  return database;
}

namespace {

namespace fs = std::filesystem;

constexpr int patience = 10'000;  // [ms], while others have the file locked
constexpr const char* first_look = "SELECT count(*) FROM sqlite_schema";

/// Absolute, so that SQLite takes no path for one of its special names.
std::unique_ptr<SQLite::Database> opened(const fs::path& file, int flags) {
  return guarded(std::make_unique<SQLite::Database>(fs::absolute(file).string(), flags, patience));
}

/// Opens it as an immutable file: without locks, recovery and files beside it.
std::unique_ptr<SQLite::Database> opened_as_it_is(const fs::path& file) {
  std::string address = "file:";
  for (const char c : fs::canonical(file).string()) {
    const auto byte = static_cast<unsigned char>(c);
    address +=
        std::isalnum(byte) != 0 || c == '/' ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return guarded(std::make_unique<SQLite::Database>(
      address + "?immutable=1", SQLite::OPEN_READONLY | SQLite::OPEN_URI, patience));
}

/// Called before SQLite opens the file: SQLite would block on a pipe, and take an empty file for a
/// database without tables.
void check_kind(const fs::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0 || ::access(file.c_str(), R_OK) != 0) {
    throw InputError(fmt::format("{}: cannot be read: {}", file.string(),
                                 std::generic_category().message(errno)));
  }
  if (!S_ISREG(status.st_mode)) throw Damage("it is no file, but a folder, device or pipe");
  if (status.st_size == 0) throw Damage("it is empty");
}

std::int64_t pragma(const SQLite::Database& database, const char* name) {
  SQLite::Statement statement(database, std::string("PRAGMA ") + name);
  Use row(statement);
  return row.next() ? row.integer(0) : 0;
}

/// Types, names and texts of the tables and indices that the schema defines.
std::set<std::tuple<std::string, std::string, std::string>> tables(
    const SQLite::Database& database) {
  std::set<std::tuple<std::string, std::string, std::string>> tables;
  SQLite::Statement statement(database, "SELECT type, name, coalesce(sql, '') FROM sqlite_schema");
  Use row(statement);
  while (row.next()) tables.emplace(row.text(0), row.text(1), row.text(2));
  return tables;
}

std::unique_ptr<SQLite::Database> empty_store() {
  auto store = std::make_unique<SQLite::Database>(":memory:", SQLite::OPEN_READWRITE);
  store->exec(embedded::schema);
  return store;
}

/// The header of a database, https://www.sqlite.org/fileformat2.html#the_database_header.
struct Header {
  std::uint32_t user_version;
  std::uint32_t application_id;
  bool is_open;  ///< its latest runs are in a file beside it, with -wal after its name
};

/// Reads the header without SQLite, which would first complete what a killed writer has left; but
/// files of other programs must not be changed. These numbers do not change after the store is
/// made; it is open while runs are added, and after its writer was killed.
Header header_of(const fs::path& file) {
  std::array<char, 72> bytes{};
  std::ifstream in(file, std::ios::binary);
  if (!in.read(bytes.data(), bytes.size()) ||
      std::string_view(bytes.data(), 16) != std::string_view("SQLite format 3\0", 16)) {
    throw Damage("file is not a database");
  }
  const auto number_at = [&](std::size_t place) {
    std::uint32_t number = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      number = number << 8 | static_cast<unsigned char>(bytes[place + k]);
    }
    return number;
  };
  constexpr std::size_t write_version = 18;
  constexpr char of_a_log = 2;
  return {number_at(60), number_at(68), bytes[write_version] == of_a_log};
}

bool is_beside(const fs::path& file, const char* ending) {
  std::error_code none;
  return fs::exists(fs::canonical(file, none).string() + ending, none);
}

/// Returns true for a copy made before the store was closed, without the latest runs beside it.
bool lacks_its_log(const fs::path& file) {
  return header_of(file).is_open && !is_beside(file, "-wal") && !is_beside(file, "-lock");
}

/// Throws Damage if what is beside the file is none of SQLite's: it would write through a link.
void check_what_is_beside(const fs::path& file) {
  for (const char* ending : {"-wal", "-shm", "-journal"}) {
    const fs::path beside = fs::canonical(file).string() + ending;
    std::error_code none;
    const fs::file_status status = fs::symlink_status(beside, none);
    if (!fs::exists(status) || fs::is_regular_file(status)) continue;
    throw Damage(beside.filename().string() + " beside it is a link, folder, device or pipe");
  }
}

void check_identity(const fs::path& file, const SQLite::Database& model) {
  check_kind(file);
  check_what_is_beside(file);
  const Header header = header_of(file);
  if (header.application_id != pragma(model, "application_id")) {
    throw Damage("another program made it");
  }
  if (header.user_version != suite_version) {
    throw Damage(fmt::format(
        "made by version {} of the suite, this is version {}; run the plan again, or use {}",
        header.user_version, suite_version,
        header.user_version == 1 ? "ricochet 0.1" : "the ricochet that made it"));
  }
}

void check_whole(const SQLite::Database& database, const SQLite::Database& model) {
  const auto there = tables(database);
  const auto ours = tables(model);
  for (const auto& table : ours) {
    if (!there.contains(table)) throw Damage("it lacks the table or view " + std::get<1>(table));
  }
  for (const auto& [type, name, text] : there) {
    if (!ours.contains({type, name, text})) {
      throw Damage(fmt::format("it has a {} {} that no store has", type, name));
    }
  }
  SQLite::Statement integrity(database, "PRAGMA integrity_check(1)");
  Use finding(integrity);
  if (!finding.next() || finding.text(0) != "ok") throw Damage("it is damaged");
  SQLite::Statement references(database, "PRAGMA foreign_key_check");
  Use astray(references);
  if (astray.next()) throw Damage("it is damaged: a row of " + astray.text(0) + " is astray");
}

bool has_pending_changes(const fs::path& file) {
  std::error_code none;
  const fs::path log = fs::canonical(file).string() + "-wal";
  return fs::exists(log, none) && fs::file_size(log, none) > 0;
}

/// Reads all: a damaged store is not added to.
void check_runs(SQLite::Database& database) {
  description_in(database);
  RunRows(database).each([](const StoredRun&) {});
}

/// Applies to a copy what a killed writer has left beside the file, and reads all of it: only a
/// whole store is changed so. Throws Damage.
void rehearse(const fs::path& file) {
  const ScratchFolder folder;
  const fs::path copy = folder.path() / "runs.sqlite";
  for (const char* ending : {"", "-wal", "-journal"}) {
    const fs::path left = fs::canonical(file).string() + ending;
    if (fs::exists(left)) fs::copy_file(left, copy.string() + ending);
  }
  check_log(copy.string() + "-wal");
  const auto database = opened(copy, SQLite::OPEN_READWRITE);
  check_whole(*database, *empty_store());
  check_runs(*database);
}

/// The database for readers, after its identity is checked.
std::unique_ptr<SQLite::Database> readable(const fs::path& file) {
  if (lacks_its_log(file)) return opened_as_it_is(file);  // else SQLite would make an empty one
  auto database = opened(file, SQLite::OPEN_READONLY);
  if (database->tryExec(first_look) == SQLITE_OK) return database;
  const int error = database->getErrorCode();
  const int reason = database->getExtendedErrorCode();
  database.reset();
  if (reason == SQLITE_READONLY_ROLLBACK || reason == SQLITE_READONLY_RECOVERY) {
    // The writer was killed while it was changing the file to its closed state.
    rehearse(file);
    opened(file, SQLite::OPEN_READWRITE)->tryExec(first_look);
    return opened(file, SQLite::OPEN_READONLY);
  }
  // A store that was not closed cannot be shared if its folder is read-only.
  if ((error == SQLITE_CANTOPEN || error == SQLITE_READONLY) && !has_pending_changes(file)) {
    return opened_as_it_is(file);
  }
  return opened(file, SQLite::OPEN_READONLY);  // its first use reports the error
}

std::unique_ptr<SQLite::Database> checked(const fs::path& file) {
  const auto model = empty_store();
  check_identity(file, *model);
  if (!WriterLock::is_taken(file)) check_log(fs::canonical(file).string() + "-wal");
  auto database = readable(file);
  check_whole(*database, *model);
  return database;
}

std::unique_ptr<SQLite::Database> writable(const fs::path& file) {
  auto database = opened(file, SQLite::OPEN_READWRITE);
  const std::string mode = database->execAndGet("PRAGMA journal_mode = WAL").getString();
  if (mode != "wal") throw Damage("nothing can be written there");
  database->exec("PRAGMA synchronous = NORMAL; PRAGMA foreign_keys = ON");
  return database;
}

/// Closes a store whose writer was killed. Does nothing if a process is adding runs, or nothing can
/// be written in its folder.
void close_what_is_left(const fs::path& file) {
  const Uninterrupted whole;
  const auto lock = WriterLock::taken_if_free(file);
  if (!lock || ::access(file.c_str(), W_OK) != 0) return;
  try {
    if (has_pending_changes(file)) rehearse(file);
  } catch (const fs::filesystem_error&) {  // no room for a copy
    return;
  }
  close_database(*opened(file, SQLite::OPEN_READWRITE));
}

template <class Work>
auto explained(const fs::path& file, const Work& work) {
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    throw InputError(
        fmt::format("{}: cannot be opened as a campaign: {}", file.string(), error.what()));
  } catch (const Damage& error) {
    throw InputError(
        fmt::format("{}: cannot be opened as a campaign: {}", file.string(), error.what()));
  }
}

}  // namespace

void check_is_store(const fs::path& file) {
  explained(file, [&] { check_identity(file, *empty_store()); });
}

void check_store(const fs::path& file) {
  explained(file, [&] {
    check_runs(*checked(file));
    if (has_pending_changes(file)) rehearse(file);
  });
}

std::unique_ptr<SQLite::Database> opened_for_reading(const fs::path& file, const fs::path& named) {
  return explained(named.empty() ? file : named, [&] {
    auto database = checked(file);
    if (!is_beside(file, "-wal") && !is_beside(file, "-lock")) return database;
    database.reset();
    close_what_is_left(file);
    return readable(file);
  });
}

std::unique_ptr<SQLite::Database> opened_for_adding(const fs::path& file) {
  return explained(file, [&] { return writable(file); });
}

void close_database(SQLite::Database& database) {
  database.tryExec("PRAGMA busy_timeout = 0; PRAGMA wal_checkpoint(TRUNCATE)");
  database.tryExec("PRAGMA journal_mode = DELETE");
  database.tryExec("PRAGMA query_only = ON");
}

std::string caution(const fs::path& file) {
  if (is_archive(file)) return "";
  if (WriterLock::is_taken(file)) {
    return fmt::format("{}: another ricochet is adding runs to it: later ones are missing",
                       file.string());
  }
  if (!lacks_its_log(file)) return "";
  return fmt::format(
      "{0}: runs may be missing: it was copied while it was open, without {1}-wal: copy that, too, "
      "or let ricochet digest close it first",
      file.string(), file.filename().string());
}

namespace {

static_assert(std::endian::native == std::endian::little, "blobs are little-endian");

[[noreturn]] void damaged(const SQLite::Column& column) {
  throw Damage(std::string("a value of ") + column.getName() + " is of no type that it has");
}

}  // namespace

void Use::bind(int parameter, double value) {
  if (std::isnan(value) || (value == 0 && std::signbit(value))) {
    statement_.bind(parameter, &value, sizeof value);
  } else {
    statement_.bind(parameter, value);
  }
}

void Use::bind(int parameter, const Vector& value) {
  // An empty vector is an empty blob, not NULL, which a null pointer would give.
  const void* coordinates = value.size() == 0 ? "" : static_cast<const void*>(value.data());
  statement_.bind(parameter, coordinates,
                  static_cast<int>(sizeof(double)) * static_cast<int>(value.size()));
}

std::int64_t Use::integer(int column) const {
  const SQLite::Column value = statement_.getColumn(column);
  if (!value.isInteger()) damaged(value);
  return value.getInt64();
}

int Use::count(int column) const {
  const std::int64_t number = integer(column);
  if (number >= 0 && number <= std::numeric_limits<int>::max()) return static_cast<int>(number);
  throw Damage(
      std::string(statement_.getColumn(column).getName()) +
      fmt::format(" is {}: must be from 0 to {}", number, std::numeric_limits<int>::max()));
}

double Use::number(int column) const {
  const SQLite::Column value = statement_.getColumn(column);
  if (value.isFloat()) return value.getDouble();
  double number = 0;
  if (!value.isBlob() || value.getBytes() != sizeof number) damaged(value);
  std::memcpy(&number, value.getBlob(), sizeof number);
  return number;
}

std::string Use::text(int column) const {
  const SQLite::Column value = statement_.getColumn(column);
  if (!value.isText()) damaged(value);
  return value.getString();
}

Vector Use::point(int column) const {
  const SQLite::Column value = statement_.getColumn(column);
  const int bytes = value.isBlob() ? value.getBytes() : 1;
  if (bytes % static_cast<int>(sizeof(double)) != 0) damaged(value);
  Vector x(bytes / static_cast<int>(sizeof(double)));
  if (bytes > 0) std::memcpy(x.data(), value.getBlob(), static_cast<std::size_t>(bytes));
  return x;
}

}  // namespace ricochet
