#include "src/core/name.h"

#include <algorithm>

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

}  // namespace ricochet
