#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace ricochet {

/// parse_toml() of a file; reads no more than the limit, as it may be a pipe or endless.
toml::table parse_toml_file(const std::string& path);

/// The text of a TOML file, up to one byte beyond the limit. Throws InputError if it cannot be
/// read.
std::string read_toml_text(const std::string& path);

/// Limits of a TOML text: its parser needs some hundred bytes of memory for each byte, and calls
/// itself for every nested table.
inline constexpr std::size_t longest_toml = 4'000'000;  ///< [bytes]
inline constexpr int deepest_toml = 32;                 ///< names in one key: a.b.c has three

/// The tables of a TOML text. Throws InputError, with origin and line, for invalid TOML and for a
/// text beyond these limits.
toml::table parse_toml(const std::string& text, const std::string& origin);

/// Gives a key of an older version, which is there in place of `key`, today's name, with a warning
/// that begins with `place`.
void rename_key(toml::table& table, std::string_view old_key, std::string_view key,
                const std::string& place);

/// The same tables as JSON text; what is not finite becomes a text there.
std::string json_of_toml(const toml::table& table);

/// A value as TOML writes it, in one line, for a message; {...} for a table.
std::string toml_value(const toml::node& value);

/// The shortest TOML float that reads back to the same number.
std::string toml_float(double x);

}  // namespace ricochet
