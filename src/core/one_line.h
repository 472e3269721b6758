#pragma once

#include <string>
#include <string_view>

namespace ricochet {

/// The text as one line that is safe on a terminal: control characters, those of the
/// writing direction, line separators and invalid UTF-8 are written as \x1b, and of more than a few
/// thousand bytes the middle is left out.
std::string one_line(std::string_view text);

}  // namespace ricochet
