#pragma once

#include <filesystem>

#include "src/core/interruption.h"

namespace ricochet {

/// A new folder below that for temporary files (the environment's TMPDIR, else /tmp), removed with
/// all that is in it at the end and at an interruption.
class ScratchFolder {
 public:
  /// Throws OutputError if it cannot be made.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  void remove() const;

  std::filesystem::path path_;
  AtInterruption interrupted_;
};

}  // namespace ricochet
