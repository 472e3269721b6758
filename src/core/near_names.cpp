#include "src/core/near_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <utility>

namespace ricochet {
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

}  // namespace ricochet
