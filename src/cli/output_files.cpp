#include "src/cli/output_files.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "ricochet/error.h"

namespace ricochet::cli {
namespace {

/// Returns true if both are, or would be, the same regular file.
bool are_same(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code none;
  if (std::filesystem::exists(a, none) && !std::filesystem::is_regular_file(a, none)) return false;
  return std::filesystem::equivalent(a, b, none) ||
         std::filesystem::weakly_canonical(a, none) == std::filesystem::weakly_canonical(b, none);
}

}  // namespace

void refuse_same_file(const char* option, const std::string& file, const std::string& other,
                      const char* what) {
  if (file.empty() || other.empty() || !are_same(file, other)) return;
  throw InputError(fmt::format("{} {}: must be another file than {}", option, file, what));
}

}  // namespace ricochet::cli
