#pragma once

#include <filesystem>

#include "src/core/made_folder.h"

namespace ricochet {

/// A folder, made if missing, that no other process can lock while this object lives.
class FolderLock {
 public:
  /// Throws as MadeFolder does, and InputError if another process has locked the folder.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  MadeFolder made_;
  int descriptor_;
};

}  // namespace ricochet
