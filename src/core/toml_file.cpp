#include "src/core/toml_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "ricochet/error.h"
#include "src/core/toml_text.h"

namespace ricochet {

std::string read_toml_text(const std::filesystem::path& path) {
  std::string text(longest_toml + 1, '\0');
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (stream) stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream.is_open() || stream.bad()) {
    const int error = errno;
    throw InputError(
        fmt::format("{}: {}", path.string(),
                    error == ENOENT ? "there is no such file"
                                    : "cannot be read: " + std::generic_category().message(error)));
  }
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

toml::table parse_toml_file(const std::filesystem::path& path) {
  return parse_toml(read_toml_text(path), path.string());
}

}  // namespace ricochet
