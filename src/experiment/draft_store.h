#pragma once

#include <SQLiteCpp/Database.h>

#include <filesystem>
#include <memory>

#include "src/core/progress.h"
#include "src/experiment/store.h"

namespace ricochet {

/// A new store in a temporary file until place() moves it; without place() the file is removed.
class DraftStore {
 public:
  enum class Place { must_be_free, is_replaced };

  /// Throws InputError if the file exists, unless it is to be replaced, or cannot be made, and as
  /// add_description does; OutputError if the disk is full.
  DraftStore(std::filesystem::path file, const CampaignDescription& description,
             Place where = Place::must_be_free);
  ~DraftStore();
  DraftStore(const DraftStore&) = delete;
  DraftStore& operator=(const DraftStore&) = delete;

  SQLite::Database& database() { return *database_; }

  /// Moves it to its place, all or nothing. Throws as the constructor does.
  void place();

 private:
  void check_absent() const;
  void discard();

  std::filesystem::path file_;
  Place where_;
  std::filesystem::path draft_;
  std::unique_ptr<SQLite::Database> database_;
  AtInterruption interrupted_;
};

/// Ensures that no other process writes to the file while this object lives: a lock on a file
/// beside it, with -lock after its name. A lock on the file itself would release SQLite's own when
/// it is given back.
class WriterLock {
 public:
  /// Throws InputError if another process has the lock, or no file can be made beside the file.
  explicit WriterLock(const std::filesystem::path& file);
  /// Null instead of an error.
  static std::unique_ptr<WriterLock> taken_if_free(const std::filesystem::path& file);
  ~WriterLock();
  WriterLock(const WriterLock&) = delete;
  WriterLock& operator=(const WriterLock&) = delete;

  /// Returns true if a process has the lock.
  static bool is_taken(const std::filesystem::path& file);

 private:
  bool is_there() const;

  std::filesystem::path lock_;
  int descriptor_;
};

/// Throws Damage if a file is not what SQLite writes beside a database and its killed writer
/// leaves: frames with the right checksums, of which the last may be torn. SQLite itself would take
/// no notice of what comes after a wrong one, and remove it.
/// https://www.sqlite.org/fileformat2.html#the_write_ahead_log
void check_log(const std::filesystem::path& log);

}  // namespace ricochet
