#pragma once

#include <string>
#include <string_view>

namespace ricochet {

/// What is_name() allows, in words.
extern const std::string names_in_words;

/// Returns true for a name that can stand in lists, patterns, tables and names of files: 1 to 60
/// letters, digits and the characters - _ . +, of which the first is no dot.
bool is_name(std::string_view text);

}  // namespace ricochet
