#pragma once

#include <SQLiteCpp/Database.h>

#include <filesystem>
#include <memory>

#include "src/core/interruption.h"
#include "src/store/store.h"

namespace ricochet {

/// A new store, aside until it is put into its place; a draft that is not leaves no trace.
class DraftStore {
 public:
  /// Throws InputError where the file is there already or can be none, or as add_description does;
  /// OutputError where the disk is full.
  DraftStore(std::filesystem::path file, const CampaignDescription& description);
  ~DraftStore();
  DraftStore(const DraftStore&) = delete;
  DraftStore& operator=(const DraftStore&) = delete;

  SQLite::Database& database() { return *database_; }

  /// Puts it there, all or nothing. Throws as the constructor does.
  void place();

 private:
  void check_absent() const;
  void discard();

  std::filesystem::path file_;
  std::filesystem::path draft_;
  std::unique_ptr<SQLite::Database> database_;
  AtInterruption interrupted_;
};

}  // namespace ricochet
