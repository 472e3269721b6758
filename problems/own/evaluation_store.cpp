#include "problems/own/evaluation_store.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <utility>

#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/experiment/store_file.h"

namespace ricochet::own {

namespace {

constexpr int patience = 60'000;         // [ms], while others have the file locked
constexpr int application = 0x52436f45;  // "RCoE"
constexpr double worth_a_flush = 0.05;   // [s]; a flush to the disk takes about a tenth of it

constexpr const char* schema = R"(
CREATE TABLE IF NOT EXISTS evaluations(
  content TEXT NOT NULL,      -- hash of the program
  run TEXT NOT NULL,          -- which asked, if values are noisy; else empty
  point BLOB NOT NULL,        -- coordinates, as doubles
  attempt INTEGER NOT NULL,   -- 0, or the number of the run's evaluation of this point
  derivatives INTEGER NOT NULL,
  numbers BLOB NOT NULL,      -- doubles: objective, constraints, gradient, Jacobian, residuals, their Jacobian
  objective REAL,
  seconds REAL NOT NULL,
  failure TEXT NOT NULL,      -- why there are no values; else empty
  PRIMARY KEY(content, run, point, attempt)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS asked(  -- where values are told
  id INTEGER PRIMARY KEY,
  content TEXT NOT NULL, run TEXT NOT NULL, point BLOB NOT NULL, attempt INTEGER NOT NULL,
  derivatives INTEGER NOT NULL,
  UNIQUE(content, run, point, attempt)))";

/// Binds what an evaluation and a point that is asked for have in common.
void bind_key(SQLite::Statement& statement, const std::string& content, const EvaluationKey& key,
              const std::string& point) {
  statement.bind(1, content);
  statement.bind(2, key.run);
  statement.bind(3, point.data(), static_cast<int>(point.size()));
  statement.bind(4, key.attempt);
}

std::string bytes_of_point(const Vector& x) {
  return {reinterpret_cast<const char*>(x.data()),
          static_cast<std::size_t>(x.size()) * sizeof(double)};
}

std::int64_t pragma(SQLite::Database& database, const char* name) {
  return database.execAndGet(std::string("PRAGMA ") + name).getInt64();
}

std::unique_ptr<SQLite::Database> opened(const std::filesystem::path& file) {
  auto database = guarded(
      std::make_unique<SQLite::Database>(std::filesystem::absolute(file).string(),
                                         SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, patience));
  const bool fresh = pragma(*database, "schema_version") == 0;
  if (!fresh && pragma(*database, "application_id") != application) {
    throw InputError(file.string() + ": is no file of evaluations");
  }
  database->exec("PRAGMA journal_mode = WAL");
  database->exec("PRAGMA synchronous = NORMAL");
  if (fresh) database->exec(fmt::format("PRAGMA application_id = {}", application));
  database->exec(schema);
  return database;
}

}  // namespace

EvaluationStore::EvaluationStore(std::filesystem::path file, std::string content)
    : file_(std::move(file)), content_(std::move(content)) {}

EvaluationStore::~EvaluationStore() {
  close();
}

void EvaluationStore::close() {
  if (owner_ != getpid()) database_.release();  // NOLINT: the connection is another process's
  database_.reset();
  owner_ = 0;
}

SQLite::Database& EvaluationStore::database() {
  if (owner_ == getpid()) return *database_;
  close();
  try {
    database_ = opened(file_);
  } catch (const SQLite::Exception& error) {
    throw InputError(
        fmt::format("{}: cannot be used to keep evaluations: {}", file_.string(), error.what()));
  }
  owner_ = getpid();
  return *database_;
}

std::optional<Given> EvaluationStore::find(const ProblemFile& file, const EvaluationKey& key,
                                           const Vector& x, bool derivatives) {
  const std::scoped_lock lock(mutex_);
  SQLite::Statement row(database(),
                        "SELECT derivatives, numbers, seconds, failure FROM evaluations WHERE "
                        "content = ? AND run = ? AND point = ? AND attempt = ?");
  const std::string point = bytes_of_point(x);
  bind_key(row, content_, key, point);
  if (!row.executeStep()) return std::nullopt;
  const bool has_derivatives = row.getColumn(0).getInt() != 0;
  Given given = nothing_given(file, has_derivatives);
  given.failure = row.getColumn(3).getString();
  if (derivatives && !has_derivatives) {
    if (given.failure.empty()) return std::nullopt;
    Given failed = nothing_given(file, true);
    failed.failure = given.failure;
    given = failed;
  } else if (!read_bytes(row.getColumn(1).getString(), given)) {
    return std::nullopt;  // of a damaged file
  }
  given.seconds = row.getColumn(2).getDouble();
  return given;
}

Given EvaluationStore::keep(const ProblemFile& file, const EvaluationKey& key, const Vector& x,
                            bool derivatives, const Given& given) {
  bool is_new = false;
  {
    const std::scoped_lock lock(mutex_);
    SQLite::Database& kept = database();
    const bool flush = given.seconds >= worth_a_flush;
    if (flush) kept.exec("PRAGMA synchronous = FULL");
    SQLite::Statement add(
        kept,
        "INSERT INTO evaluations VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO UPDATE SET "
        "derivatives = excluded.derivatives, numbers = excluded.numbers, "
        "objective = excluded.objective, seconds = seconds + excluded.seconds, "
        "failure = excluded.failure WHERE derivatives < excluded.derivatives");
    const std::string point = bytes_of_point(x), numbers = bytes_of(given);
    bind_key(add, content_, key, point);
    add.bind(5, derivatives ? 1 : 0);
    add.bind(6, numbers.data(), static_cast<int>(numbers.size()));
    if (!std::isnan(given.objective)) add.bind(7, given.objective);
    add.bind(8, given.seconds);
    add.bind(9, given.failure);
    try {
      is_new = add.exec() > 0;
    } catch (const SQLite::Exception& error) {
      throw OutputError(
          fmt::format("{}: an evaluation could not be kept: {}", file_.string(), error.what()));
    }
    if (flush) kept.exec("PRAGMA synchronous = NORMAL");
  }
  return is_new ? given : find(file, key, x, derivatives).value_or(given);
}

std::int64_t EvaluationStore::ask(const EvaluationKey& key, const Vector& x, bool derivatives) {
  const std::scoped_lock lock(mutex_);
  SQLite::Statement row(database(),
                        "INSERT INTO asked(content, run, point, attempt, derivatives) VALUES (?, "
                        "?, ?, ?, ?) ON CONFLICT DO UPDATE SET derivatives = max(derivatives, "
                        "excluded.derivatives) RETURNING id");
  const std::string point = bytes_of_point(x);
  bind_key(row, content_, key, point);
  row.bind(5, derivatives ? 1 : 0);
  row.executeStep();
  const std::int64_t id = row.getColumn(0).getInt64();
  while (row.executeStep()) {
  }
  return id;
}

std::vector<AskedPoint> EvaluationStore::asked() {
  const std::scoped_lock lock(mutex_);
  SQLite::Statement row(database(),
                        "SELECT id, run, point, attempt, derivatives, EXISTS (SELECT 1 FROM "
                        "evaluations e WHERE e.content = a.content AND e.run = a.run AND e.point = "
                        "a.point AND e.attempt = a.attempt AND e.derivatives >= a.derivatives) "
                        "FROM asked a WHERE content = ? ORDER BY id");
  row.bind(1, content_);
  std::vector<AskedPoint> points;
  while (row.executeStep()) {
    const std::string bytes = row.getColumn(2).getString();
    Vector x(static_cast<Eigen::Index>(bytes.size() / sizeof(double)));
    std::memcpy(x.data(), bytes.data(), static_cast<std::size_t>(x.size()) * sizeof(double));
    points.push_back({row.getColumn(0).getInt64(),
                      {row.getColumn(1).getString(), row.getColumn(3).getInt64()},
                      std::move(x),
                      row.getColumn(4).getInt() != 0,
                      row.getColumn(5).getInt() != 0});
  }
  return points;
}

void EvaluationStore::forget(const AskedPoint& point) {
  const std::scoped_lock lock(mutex_);
  SQLite::Statement row(database(),
                        "DELETE FROM evaluations WHERE content = ? AND run = ? AND point = ? AND "
                        "attempt = ?");
  const std::string bytes = bytes_of_point(point.x);
  bind_key(row, content_, point.key, bytes);
  row.exec();
}

std::int64_t EvaluationStore::forget_if_all_failed() {
  const std::scoped_lock lock(mutex_);
  SQLite::Statement forget(database(),
                           "DELETE FROM evaluations WHERE content = ?1 AND NOT EXISTS (SELECT 1 "
                           "FROM evaluations WHERE content = ?1 AND failure = '')");
  forget.bind(1, content_);
  return forget.exec();
}

std::vector<FailureCount> EvaluationStore::failures() {
  const std::scoped_lock lock(mutex_);
  SQLite::Statement rows(database(),
                         "SELECT failure, count(*) FROM evaluations WHERE content = ? AND failure "
                         "<> '' GROUP BY failure ORDER BY count(*) DESC, failure");
  rows.bind(1, content_);
  std::vector<FailureCount> failures;
  while (rows.executeStep()) {
    failures.push_back({rows.getColumn(0).getString(), rows.getColumn(1).getInt64()});
  }
  return failures;
}

}  // namespace ricochet::own
