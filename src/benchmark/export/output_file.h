#pragma once

#include <cstdio>
#include <filesystem>
#include <string_view>

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

}  // namespace ricochet::exports
