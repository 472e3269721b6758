#include "src/core/toml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "ricochet/error.h"
#include "src/core/progress.h"

namespace ricochet {

std::string read_toml_text(const std::string& path) {
  std::string text(longest_toml + 1, '\0');
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (stream) stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream.is_open() || stream.bad()) {
    const int error = errno;
    throw InputError(
        fmt::format("{}: {}", path,
                    error == ENOENT ? "there is no such file"
                                    : "cannot be read: " + std::generic_category().message(error)));
  }
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

toml::table parse_toml_file(const std::string& path) {
  return parse_toml(read_toml_text(path), path);
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

InputError invalid_toml(const toml::parse_error& error, const std::string& origin) {
  return InputError(fmt::format("{}:{}: not valid TOML: {}", origin, error.source().begin.line,
                                error.description()));
}

// Of a date or time in a message, fractions of a second and time zone do not matter.
std::string text_of(const toml::date& date) {
  return fmt::format("{:04}-{:02}-{:02}", date.year, date.month, date.day);
}
std::string text_of(const toml::time& time) {
  return fmt::format("{:02}:{:02}:{:02}", time.hour, time.minute, time.second);
}
std::string text_of(const toml::date_time& both) {
  return text_of(both.date) + "T" + text_of(both.time);
}
std::string text_of(const std::string& text) {
  const char quote = text.find('\'') == std::string::npos ? '\'' : '"';
  return quote + text + quote;
}
std::string text_of(std::int64_t number) {
  return fmt::format("{}", number);
}
std::string text_of(double number) {
  return toml_float(number);
}
std::string text_of(bool truth) {
  return truth ? "true" : "false";
}

}  // namespace

toml::table parse_toml(const std::string& text, const std::string& origin) {
  if (text.size() > longest_toml) {
    throw InputError(fmt::format("{}: too long: must have at most {} bytes", origin, longest_toml));
  }
  check_depth(text, origin);
#if TOML_EXCEPTIONS
  try {
    return toml::parse(text, origin);
  } catch (const toml::parse_error& error) {
    throw invalid_toml(error, origin);
  }
#else  // the live page's module, where nothing is caught
  toml::parse_result result = toml::parse(text, origin);
  if (!result) throw invalid_toml(result.error(), origin);
  return std::move(result).table();
#endif
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

// Without streams: with their locales the live page's module would be half as large again.
std::string toml_value(const toml::node& value) {
  return value.visit([](const auto& shown) -> std::string {
    if constexpr (toml::is_table<decltype(shown)>) {
      return "{...}";
    } else if constexpr (toml::is_array<decltype(shown)>) {
      std::string list;
      for (const toml::node& each : shown) list += (list.empty() ? " " : ", ") + toml_value(each);
      return list.empty() ? "[]" : "[" + list + " ]";
    } else {
      return text_of(shown.get());
    }
  });
}

std::string toml_float(double x) {
  const std::string text = fmt::format("{}", x);
  return text.find_first_of(".einf") == std::string::npos ? text + ".0" : text;
}

}  // namespace ricochet
