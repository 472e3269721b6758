#pragma once

#include <cstdio>
#include <filesystem>
#include <string_view>

#include "src/core/files.h"
#include "src/core/progress.h"

namespace ricochet::exports {

/// A new file that is written piece by piece, because its content need not fit into memory.
class OutputFile {
 public:
  /// Throws OutputError or InputError, one line with the file and the reason, as do the other
  /// members.
  explicit OutputFile(std::filesystem::path file);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view text);

  /// Must be called at the end: a disk may report only then that it is full.
  void close();

 private:
  std::filesystem::path file_;
  std::FILE* stream_ = nullptr;
};

/// Writes a new file with this text.
void write_file(const std::filesystem::path& file, std::string_view text);

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
