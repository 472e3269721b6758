#pragma once

#include <filesystem>
#include <vector>

#include "src/core/interruption.h"

namespace ricochet {

/// Makes a folder and what is missing above it, and takes back at the end what is still empty.
class MadeFolder {
 public:
  /// Throws InputError, one line with path and reason, and leaves no trace, where it cannot be made
  /// or not be written to; OutputError where the disk is full.
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
