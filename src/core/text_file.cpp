#include "src/core/text_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "src/core/error.h"

namespace ricochet {

void write_text_file(const std::filesystem::path& path, const std::string& text) {
  const auto fail = [&path](const std::string& reason) {
    throw InputError(fmt::format("{}: cannot be written: {}", path.string(), reason));
  };
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) fail("it is a folder");
  std::filesystem::path draft = path;
  draft += fmt::format(".{}.part", getpid());
  {
    errno = 0;
    std::ofstream stream(draft, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream) {
      const std::string reason = std::generic_category().message(errno);
      std::filesystem::remove(draft, error);
      fail(reason);
    }
  }
  std::filesystem::rename(draft, path, error);
  if (error) {
    const std::string reason = error.message();
    std::filesystem::remove(draft, error);
    fail(reason);
  }
}

}  // namespace ricochet
