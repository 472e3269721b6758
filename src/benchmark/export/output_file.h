#pragma once

#include <cstdio>
#include <filesystem>
#include <string_view>

namespace ricochet::exports {

/// A new file that is written piece by piece, as what goes into it need not fit into memory.
class OutputFile {
 public:
  /// Throws OutputError or InputError, one line with the file and the reason, as the others do.
  explicit OutputFile(std::filesystem::path file);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view text);

  /// To be called in the end: a disk may tell only then that it is full.
  void close();

 private:
  std::filesystem::path file_;
  std::FILE* stream_ = nullptr;
};

/// A new file with this text.
void write_file(const std::filesystem::path& file, std::string_view text);

}  // namespace ricochet::exports
