#pragma once

#include <string>
#include <string_view>

namespace ricochet {

/// A text as a field of a CSV file: quoted where it must be (RFC 4180), and with a ' before it
/// where a spreadsheet would take it for a formula, since it begins with = + - @, a tab or a line
/// break. A number, such as -1.5 or -inf, stays as it is.
std::string csv_field(std::string_view text);

}  // namespace ricochet
