#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ricochet::exports {

/// A line with these fields; those with a comma, a quote or a line break are quoted (RFC 4180). The
/// line ends as others here do, without a carriage return.
std::string csv_row(const std::vector<std::string>& fields);

/// The shortest decimal that reads back to the number: "inf", "-inf" and "nan" are such, too.
std::string number(double value);
std::string number(const std::optional<double>& value);  ///< empty where there is none

}  // namespace ricochet::exports
