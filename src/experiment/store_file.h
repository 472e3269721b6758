#pragma once

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "ricochet/problem.h"

namespace ricochet {

/// Throws InputError if the file is no store of this version of the suite, judging by its first
/// page. Writes nothing, and makes no file beside it.
void check_is_store(const std::filesystem::path& file);

/// Reads all of it, and throws InputError as Store::open and its readers do. Takes some seconds for
/// a million runs.
void check_store(const std::filesystem::path& file);

/// A file may be a stranger's: nothing that it brings along runs, and nothing in it is endless.
std::unique_ptr<SQLite::Database> guarded(std::unique_ptr<SQLite::Database> database);

/// Opens the file of a store to read it, after these checks. Closes what a killed writer left open,
/// and rolls back what it left half changed; else writes nothing. Messages name the file `named`,
/// from which this one was unpacked, if that is not empty.
std::unique_ptr<SQLite::Database> opened_for_reading(const std::filesystem::path& file,
                                                     const std::filesystem::path& named = {});

/// Opens it to add runs; the caller must have checked it, and hold a WriterLock.
std::unique_ptr<SQLite::Database> opened_for_adding(const std::filesystem::path& file);

/// Moves all runs into the one file, which can be read in a read-only folder, and lets the database
/// read only. Leaves the runs in two files while others read them. Never waits.
void close_database(SQLite::Database& database);

/// The data read differ from those written.
class Damage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns what `work` returns. Throws its Damage with the table and the number of the row, in
/// which an inner call has named another.
template <class Work>
auto in_row(const char* table, std::int64_t row, const Work& work) {
  try {
    return work();
  } catch (const Damage& damage) {
    const std::string reason = damage.what();
    if (reason.starts_with("table ")) throw;
    throw Damage("table " + std::string(table) + ", row " + std::to_string(row) + ": " + reason);
  }
}

/// One use of a prepared statement. It resets the statement first, even after a failure.
class Use {
 public:
  explicit Use(SQLite::Statement& statement) : statement_(statement) { statement_.tryReset(); }
  ~Use() { statement_.tryReset(); }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;

  /// Binds the next parameters.
  template <class... Values>
  Use& with(const Values&... values) {
    (bind(++bound_, values), ...);
    return *this;
  }

  bool next() { return statement_.executeStep(); }
  void execute() { statement_.exec(); }

  // A value of the row, columns counted from 0. Throws Damage if it has another type or range,
  // which only happens in a damaged file.
  std::int64_t integer(int column) const;
  int count(int column) const;  ///< >= 0
  double number(int column) const;
  std::string text(int column) const;
  Vector point(int column) const;
  bool is_null(int column) const { return statement_.isColumnNull(column); }

  void read(int column, std::int64_t& target) const { target = count(column); }
  void read(int column, double& target) const { target = number(column); }
  void read(int column, std::string& target) const { target = text(column); }

 private:
  void bind(int parameter, int value) { statement_.bind(parameter, value); }
  void bind(int parameter, std::int64_t value) { statement_.bind(parameter, value); }
  void bind(int parameter, const std::string& value) { statement_.bind(parameter, value); }
  void bind(int parameter, double value);
  void bind(int parameter, const Vector& value);

  /// Binds NULL if there is no value.
  template <class Value>
  void bind(int parameter, const Value* value) {
    if (value != nullptr) {
      bind(parameter, *value);
    } else {
      statement_.bind(parameter);
    }
  }

  SQLite::Statement& statement_;
  int bound_ = 0;  ///< parameters
};

}  // namespace ricochet
