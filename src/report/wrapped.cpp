#include "src/report/wrapped.h"

#include <algorithm>
#include <sstream>

namespace ricochet::report {
namespace {

bool starts_character(char c) {
  return (c & 0xc0) != 0x80;  // of UTF-8
}

}  // namespace

int text_width(const std::string& text, int size) {
  return static_cast<int>(std::ranges::count_if(text, starts_character)) * 7 * size / 12;
}

std::string shortened(const std::string& text, double room, int size) {
  if (text_width(text, size) <= room) return text;
  std::string kept = text;
  while (!kept.empty() && text_width(kept + "…", size) > room) {
    while (kept.size() > 1 && !starts_character(kept.back())) kept.pop_back();
    kept.pop_back();
  }
  return kept + "…";
}

std::vector<std::string> wrapped(const std::string& text, double room, int size) {
  if (!text.empty() && text_width(text, size) <= room) return {text};
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!lines.empty() && text_width(lines.back() + " " + word, size) <= room) {
      lines.back() += " " + word;
    } else {
      lines.push_back(shortened(word, room, size));
    }
  }
  return lines;
}

}  // namespace ricochet::report
