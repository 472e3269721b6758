#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>

namespace ricochet {

/// parse_toml() of a file; reads no more than the limit, as it may be a pipe or endless.
toml::table parse_toml_file(const std::filesystem::path& path);

/// The text of a TOML file, up to one byte beyond the limit. Throws InputError if it cannot be
/// read.
std::string read_toml_text(const std::filesystem::path& path);

}  // namespace ricochet
