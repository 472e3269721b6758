#pragma once

#include <map>
#include <string>

#include "src/report/json.h"

namespace ricochet::report {

/// Number of significant digits that are kept, by the name of the number in the data.
using Digits = std::map<std::string, int, std::less<>>;

/// Returns the text of a report's data.json: lists of records as tables, see packed; numbers with a
/// fraction rounded to `usual_digits` significant digits or those for their name; whole numbers
/// below 2^53, and texts, exactly. Lines are kept short, so that diffs are readable.
std::string data_text(const Json& data, const Digits& digits = {});
inline constexpr int usual_digits = 6;

/// Parses such a text, or any JSON. Throws Json::exception if it is not JSON.
Json data_in(const std::string& text);

}  // namespace ricochet::report
