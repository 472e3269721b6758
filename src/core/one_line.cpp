#include "src/core/one_line.h"

#include <fmt/format.h>

#include <cstdint>

namespace ricochet {
namespace {

constexpr std::size_t longest_start = 3000;
constexpr std::size_t longest_end = 1000;

/// Returns true for line and paragraph separators and for controls of the writing direction, which
/// reorder what a terminal shows.
bool steers_lines(std::string_view character) {
  if (character == "\xd8\x9c") return true;  // U+061C
  if (character.size() != 3 || character[0] != '\xe2') return false;
  const auto bits = [&](std::size_t i) { return static_cast<unsigned>(character[i]) & 0x3fU; };
  const unsigned code = 0x2000U | bits(1) << 6U | bits(2);
  return code == 0x200e || code == 0x200f || (code >= 0x2028 && code <= 0x202e) ||
         (code >= 0x2066 && code <= 0x2069);
}

/// The length in bytes of the text's first character; 0 if it is invalid UTF-8 or steers a
/// terminal.
std::size_t size_of_first(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xc0U) != 0x80) return 0;
  }
  if (first == 0xc2 && byte(1) < 0xa0) return 0;
  return steers_lines(text.substr(0, size)) ? 0 : size;
}

void append_escaped(std::string& line, std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = size_of_first(text);
    if (size == 0) {
      line += fmt::format("\\x{:02x}", static_cast<std::uint8_t>(text[0]));
    } else {
      line += text.substr(0, size);
    }
    text.remove_prefix(size == 0 ? 1 : size);
  }
}

}  // namespace

std::string one_line(std::string_view text) {
  std::string line;
  if (text.size() <= longest_start + longest_end) {
    append_escaped(line, text);
    return line;
  }
  append_escaped(line, text.substr(0, longest_start));
  line += fmt::format(" ... {} bytes ... ", text.size() - longest_start - longest_end);
  append_escaped(line, text.substr(text.size() - longest_end));
  return line;
}

}  // namespace ricochet
