#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ricochet {

/// The number of letters to change, insert, delete or swap with their neighbour to turn one name
/// into the other; letter case does not matter.
int edit_distance(std::string_view a, std::string_view b);

/// Returns true if both are equal apart from letter case.
bool equal_in_any_case(std::string_view a, std::string_view b);

/// The known names that may have been meant, nearest first, at most three.
std::vector<std::string> near_names(std::string_view wanted, const std::vector<std::string>& known);

/// The hint for an unknown name: "did you mean ...?", or else the allowed names, at
/// most sixty.
std::string what_instead(std::string_view wanted, const std::vector<std::string>& known);

/// The same for names too many to print: without a near name, it gives only the command that lists
/// them.
std::string what_instead(std::string_view wanted, const std::vector<std::string>& known,
                         std::string_view listing);

/// Returns the known name that equals `wanted`, or else the only one that does apart from letter
/// case, or else nullptr.
const std::string* match(std::string_view wanted, const std::vector<std::string>& known);

}  // namespace ricochet
