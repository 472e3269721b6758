#pragma once

#include <filesystem>

#include "src/core/interruption.h"
#include "src/core/made_folder.h"

namespace ricochet::exports {

/// A folder that was empty or missing and gets all of its files at once, or none.
class OutputFolder {
 public:
  /// Throws InputError where it is a file, or has something in it already, and as MadeFolder does.
  explicit OutputFolder(std::filesystem::path folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where to write until then: a folder within it, which is removed if nothing comes of it.
  const std::filesystem::path& draft() const { return draft_; }

  /// Moves all that was written to its place.
  void commit();

 private:
  void discard() const;

  std::filesystem::path folder_;
  MadeFolder made_;
  std::filesystem::path draft_;  ///< empty once it is committed
  AtInterruption interrupted_;
};

}  // namespace ricochet::exports
