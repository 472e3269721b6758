#pragma once

#include <map>
#include <string>

#include "src/report/json.h"

namespace ricochet::report {

/// How many significant digits of numbers are kept, by the name that they have in the data.
using Digits = std::map<std::string, int, std::less<>>;

/// The text of a report's data.json: lists of records as tables, see packed; numbers with a
/// fraction rounded to `usual_digits` significant digits or those of their name; whole numbers
/// below 2^53, and texts, exactly. A line is short where it can be, so that changes are seen.
std::string data_text(const Json& data, const Digits& digits = {});
inline constexpr int usual_digits = 6;

/// The data that such a text, or any JSON, holds. Throws Json::exception where it is none.
Json data_in(const std::string& text);

}  // namespace ricochet::report
