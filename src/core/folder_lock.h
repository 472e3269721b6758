#pragma once

#include <filesystem>

#include "src/core/made_folder.h"

namespace ricochet {

/// A folder, made if missing, that no other process locks as long as this lives, or runs.
class FolderLock {
 public:
  /// Throws as MadeFolder does, and InputError where another process has locked it.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  MadeFolder made_;
  int descriptor_;
};

}  // namespace ricochet
