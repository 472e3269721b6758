#pragma once

#include <filesystem>
#include <string>

namespace ricochet::site {

/// Replaces what stands between the comments <!-- mark --> and <!-- /mark --> of a written page. A
/// page without them, or one that is missing, stays as it is.
void put_at(const std::filesystem::path& page, const std::string& mark, const std::string& html);

}  // namespace ricochet::site
