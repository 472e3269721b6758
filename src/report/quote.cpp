#include "src/report/quote.h"

namespace ricochet::report {

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') result += '\'';
    result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return result + "'";
}

std::string quoted_tick(const std::string& text) {
  constexpr std::size_t longest = 49;
  static const std::string ellipsis = "…";
  std::string result;
  std::size_t fitting = 0;  // bytes that leave room for the ellipsis
  for (const char c : text) {
    const bool starts_character = (c & 0xc0) != 0x80;
    if (starts_character && result.size() + ellipsis.size() <= longest) fitting = result.size();
    result += c == '%' ? "%%" : std::string(1, c);
  }
  if (result.size() > longest) result = result.substr(0, fitting) + ellipsis;
  return report::quoted(result);  // not the one of <iomanip>
}

}  // namespace ricochet::report
