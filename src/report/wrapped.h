#pragma once

#include <string>
#include <vector>

namespace ricochet::report {

/// Approximate width of the text in pixels; fonts are the reader's.
int text_width(const std::string& text, int size = 12);

/// Returns the text, truncated with an ellipsis if there is no room.
std::string shortened(const std::string& text, double room, int size = 12);

/// The text in lines that have room, broken at spaces.
std::vector<std::string> wrapped(const std::string& text, double room, int size = 12);

}  // namespace ricochet::report
