#include "src/core/names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <utility>

#include "ricochet/error.h"

namespace ricochet {

namespace {

constexpr std::size_t longest_name = 60;

bool may_stand_in_a_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
         c == '_' || c == '.' || c == '+';
}

}  // namespace

const std::string names_in_words =
    "1 to 60 letters, digits and the characters - _ . +, of which the first is no dot";

bool is_name(std::string_view text) {
  return !text.empty() && text.size() <= longest_name && text[0] != '.' &&
         std::all_of(text.begin(), text.end(), may_stand_in_a_name);
}

namespace {

char lower(char letter) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

/// Returns true if the name contains all the letters in this order.
bool are_within(std::string_view letters, std::string_view name) {
  std::size_t found = 0;
  for (const char letter : name) {
    if (found < letters.size() && lower(letters[found]) == lower(letter)) ++found;
  }
  return found == letters.size();
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> before, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(last, row);
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      const bool exchanged = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                             lower(a[i - 2]) == lower(b[j - 1]);
      if (exchanged) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

bool equal_in_any_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

std::vector<std::string> near_names(std::string_view wanted,
                                    const std::vector<std::string>& known) {
  constexpr std::size_t longest = 100;  // longer names are not corrected
  constexpr std::size_t most = 3;
  if (wanted.empty() || wanted.size() > longest) return {};
  std::vector<std::pair<int, std::string>> near;
  for (const std::string& name : known) {
    const int distance = edit_distance(wanted, name);
    const bool mistyped = distance <= std::max(1, static_cast<int>(wanted.size()) / 3);
    const bool shortened = wanted.size() >= 3 && are_within(wanted, name);
    if (mistyped || shortened) near.emplace_back(distance, name);
  }
  std::stable_sort(near.begin(), near.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(most, near.size()); ++i) names.push_back(near[i].second);
  return names;
}

std::string what_instead(std::string_view wanted, const std::vector<std::string>& known) {
  constexpr std::size_t most = 60;
  const std::vector<std::string> near = near_names(wanted, known);
  if (!near.empty()) return fmt::format("did you mean {}?", fmt::join(near, " or "));
  const std::size_t shown = std::min(most, known.size());
  const auto end = known.begin() + static_cast<std::ptrdiff_t>(shown);
  return fmt::format(
      "allowed: {}{}", fmt::join(known.begin(), end, ", "),
      shown == known.size() ? "" : fmt::format(", and {} more", known.size() - shown));
}

std::string what_instead(std::string_view wanted, const std::vector<std::string>& known,
                         std::string_view listing) {
  const std::vector<std::string> near = near_names(wanted, known);
  return near.empty() ? fmt::format("see {}", listing)
                      : fmt::format("did you mean {}?", fmt::join(near, " or "));
}

const std::string* match(std::string_view wanted, const std::vector<std::string>& known) {
  const auto exact = std::find(known.begin(), known.end(), wanted);
  if (exact != known.end()) return &*exact;
  const std::string* found = nullptr;
  for (const std::string& name : known) {
    if (!equal_in_any_case(name, wanted)) continue;
    if (found != nullptr) return nullptr;
    found = &name;
  }
  return found;
}

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

bool fits(const std::string& name, const std::string& pattern) {
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

bool fits_any(const std::string& name, const std::vector<std::string>& patterns) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& pattern) { return fits(name, pattern); });
}

std::vector<std::string> split_patterns(const std::string& list) {
  std::vector<std::string> patterns;
  std::istringstream text(list);
  for (std::string pattern; std::getline(text, pattern, ',');) {
    if (!pattern.empty()) patterns.push_back(pattern);
  }
  return patterns;
}

void require_fit(const std::vector<std::string>& patterns, const std::vector<std::string>& names,
                 const std::string& place, const std::string& listing) {
  const bool any = std::any_of(names.begin(), names.end(),
                               [&](const std::string& name) { return fits_any(name, patterns); });
  if (any) return;
  const std::string wanted = fmt::format("{}", fmt::join(patterns, ","));
  throw InputError(fmt::format(
      "{} {}: nothing fits; {}", place, wanted,
      listing.empty() ? what_instead(wanted, names) : what_instead(wanted, names, listing)));
}

std::string text_of(const OptionValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? fmt::format("{}", *number) : std::get<std::string>(value);
}

namespace {

/// What pandas 2.2 takes for missing by default, except the empty text and "nan"; R: "NA".
constexpr std::array<std::string_view, 17> read_as_missing = {
    "#N/A", "#N/A N/A", "#NA", "-1.#IND", "-1.#QNAN", "-NaN", "-nan", "1.#IND", "1.#QNAN",
    "<NA>", "N/A",      "NA",  "NULL",    "NaN",      "None", "n/a",  "null"};

}  // namespace

std::string label(std::string_view text) {
  if (text == "nan") return "missing-value";
  const bool swallowed =
      std::find(read_as_missing.begin(), read_as_missing.end(), text) != read_as_missing.end();
  std::string label(swallowed ? "'" : "");
  return label += text;
}

}  // namespace ricochet
