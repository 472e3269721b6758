#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "src/core/files.h"
#include "src/core/progress.h"
#include "src/report/table.h"

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

/// As value_of(), but a number that is not finite stays what it is.
template <class T>
Value cell_of(const T& x) {
  if constexpr (std::is_same_v<T, double>) {
    return x;
  } else if constexpr (std::is_same_v<T, std::optional<double>>) {
    return x ? Value(*x) : Value();
  } else if constexpr (std::is_same_v<T, std::uint64_t>) {
    return std::to_string(x);
  } else {
    return value_of(x);
  }
}

/// A file of a table whose rows need not fit into memory: CSV, or as another writer has it.
class TableFile {
 public:
  using Writer = std::function<std::string(const Table&, Lines)>;

  TableFile(const std::filesystem::path& file, std::vector<Column> columns, Writer writer = csv_of);

  template <class... Cells>
  void add(const Cells&... cells) {
    add_row({cell_of(cells)...});
  }
  void add_row(std::vector<Value> row);

  /// Writes all rows, and `foot` below them. Must be called at the end, see OutputFile.
  void close(std::string_view foot = "");

 private:
  void write();

  Table batch_;
  Writer writer_;
  bool begun_ = false;
  OutputFile file_;
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
