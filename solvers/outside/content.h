#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "src/core/fnv_hash.h"

namespace ricochet::outside {

/// What a user's solver consists of, as it was when it was added: files, by their bytes and not by
/// their names, and texts.
class Content {
 public:
  void add_text(std::string_view text);

  /// A file that cannot be read counts as an empty one.
  void add_file(const std::filesystem::path& file);

  /// 16 hexadecimal digits.
  std::string hash() const;

  /// The first of the files that is another one now; empty if all are as they were.
  std::string changed() const;

 private:
  struct File {
    std::filesystem::path path;
    struct stat status;
    std::uint64_t hash;
  };
  static File read(const std::filesystem::path& path);

  std::vector<File> files_;
  FnvHash hash_;
};

/// What a command consists of: its program, found on PATH, every file that its further words name,
/// also as --option=FILE, and the words that name none. A program of the system, such as
/// /usr/bin/python3, counts by its name only.
Content content_of_command(const std::vector<std::string>& words);

/// Returns true for a file below /usr, but not /usr/local, /bin, /sbin or /lib, wherever symbolic
/// links lead: the system's packages bring it, and an author does not edit it.
bool is_of_the_system(const std::filesystem::path& file);

}  // namespace ricochet::outside
