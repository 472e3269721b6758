#include "src/core/toml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>

#include "ricochet/error.h"
#include "src/core/progress.h"

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

namespace {

/// Refuses a key of too many names. It counts dots between parts that cannot be a list of numbers;
/// dots in strings and comments count too, which is harmless.
void check_depth(const std::string& text, const std::string& origin) {
  int names = 1;
  bool named = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '.' && named) {
      ++names;
      named = false;
    } else if (std::string_view(".=,[]{}\n").find(c) != std::string_view::npos) {
      names = 1;
      named = false;
    } else if (c != ' ' && c != '\t') {
      named = true;
    }
    if (names <= deepest_toml) continue;
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(i);
    throw InputError(fmt::format("{}:{}: a key has more than {} names: must have at most so many",
                                 origin, 1 + std::count(text.begin(), end, '\n'), deepest_toml));
  }
}

}  // namespace

toml::table parse_toml(const std::string& text, const std::string& origin) {
  if (text.size() > longest_toml) {
    throw InputError(fmt::format("{}: too long: must have at most {} bytes", origin, longest_toml));
  }
  check_depth(text, origin);
  try {
    return toml::parse(text, origin);
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: not valid TOML: {}", origin, error.source().begin.line,
                                 error.description()));
  }
}

void rename_key(toml::table& table, std::string_view old_key, std::string_view key,
                const std::string& place) {
  if (!table.contains(old_key) || table.contains(key)) return;
  warn(fmt::format("{}{} is now called {}", place, old_key, key));
  table.insert(key, *table.get(old_key));
  table.erase(old_key);
}

std::string json_of_toml(const toml::table& table) {
  std::ostringstream text;
  text << toml::json_formatter(table);
  return text.str();
}

std::string toml_float(double x) {
  const std::string text = fmt::format("{}", x);
  return text.find_first_of(".einf") == std::string::npos ? text + ".0" : text;
}

}  // namespace ricochet
