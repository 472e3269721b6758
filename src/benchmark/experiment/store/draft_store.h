#pragma once

#include <SQLiteCpp/Database.h>

#include <filesystem>
#include <memory>

#include "src/benchmark/experiment/store/store.h"
#include "src/core/interruption.h"

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

}  // namespace ricochet
