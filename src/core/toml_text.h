#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <filesystem>
#include <string>

namespace ricochet {

/// What a TOML text may have: its reader needs some hundred bytes of memory for each, and calls
/// itself for every table within a table.
inline constexpr std::size_t longest_toml = 4'000'000;  ///< [bytes]
inline constexpr int deepest_toml = 32;                 ///< names in one key: a.b.c has three

/// The tables of a TOML text. Throws InputError, with origin and line, for a text that is none, and
/// for one beyond these limits.
toml::table parse_toml(const std::string& text, const std::string& origin);

/// The same of a file, of which no more than that is read: it may be a pipe, or without end.
toml::table parse_toml_file(const std::filesystem::path& path);

/// The shortest text that reads back to the same number, as a TOML float.
std::string toml_float(double x);

}  // namespace ricochet
