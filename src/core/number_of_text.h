#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace ricochet {

/// The number that the text is, as C++ writes it, without blanks and without a plus; nothing if the
/// text is anything else or does not fit the type.
template <class Number>
std::optional<Number> number_of_text(std::string_view text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return number;
}

}  // namespace ricochet
