#pragma once

#include <filesystem>
#include <vector>

#include "src/core/interruption.h"

namespace ricochet {

/// Makes a folder and its missing parents; at the end it removes those that are still empty.
class MadeFolder {
 public:
  /// If the folder cannot be made or written to, leaves no trace and throws InputError (one line
  /// with path and reason), or OutputError if the disk is full.
  explicit MadeFolder(const std::filesystem::path& folder);
  ~MadeFolder();
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;

 private:
  void take_back() const;

  std::vector<std::filesystem::path> made_;  ///< innermost first
  AtInterruption interrupted_;
};

}  // namespace ricochet
