#pragma once

#include <filesystem>

#include "src/core/interruption.h"
#include "src/core/made_folder.h"

namespace ricochet::exports {

/// A folder that is empty or missing at first and gets all of its files at once, or none.
class OutputFolder {
 public:
  /// Throws InputError if it is a file or not empty, and as MadeFolder does.
  explicit OutputFolder(std::filesystem::path folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where to write before commit(): a folder within it, which is removed if commit() is not
  /// called.
  const std::filesystem::path& draft() const { return draft_; }

  /// Moves all written files to their place.
  void commit();

 private:
  void discard() const;

  std::filesystem::path folder_;
  MadeFolder made_;
  std::filesystem::path draft_;  ///< empty after commit()
  AtInterruption interrupted_;
};

}  // namespace ricochet::exports
