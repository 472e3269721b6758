#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ricochet::cli {

/// A file that an option asks for; without a name there is none.
struct AskedFile {
  const char* option;
  std::string file;
};

/// Throws InputError if one of the files would overwrite an input or another one.
void refuse_same_files(const std::vector<AskedFile>& asked, const std::vector<std::string>& inputs);

/// Writes all files, or none if one of them cannot be written. Each with its text; without a name
/// or a text there is none.
void write_files(const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace ricochet::cli
