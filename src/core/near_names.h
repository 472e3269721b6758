#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ricochet {

/// How many letters must be changed, put in, left out or exchanged with their neighbour to make one
/// of the other; letter case does not matter.
int edit_distance(std::string_view a, std::string_view b);

/// Whether both are the same but for their letter case.
bool equal_in_any_case(std::string_view a, std::string_view b);

/// The names that someone may have meant, the nearest first, at most three.
std::vector<std::string> near_names(std::string_view wanted, const std::vector<std::string>& known);

/// What an error says of a name that is none: "did you mean ...?", or what is allowed.
std::string what_instead(std::string_view wanted, const std::vector<std::string>& known);

}  // namespace ricochet
