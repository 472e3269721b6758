#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ricochet::exports {

/// A line with these fields, see csv_field(). It ends with a newline and without a carriage return,
/// as in all exports here.
std::string csv_row(const std::vector<std::string>& fields);

/// The shortest decimal text that reads back to the number; also "inf", "-inf" and "nan".
std::string number(double value);
std::string number(const std::optional<double>& value);  ///< empty if there is none

}  // namespace ricochet::exports
