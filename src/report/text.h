#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "src/report/json.h"

namespace ricochet::report {

/// Escapes text as content of an HTML or XML element or of a quoted attribute. Control characters,
/// which XML forbids, become spaces.
std::string escape_html(std::string_view text);

/// Escapes text as inline Markdown, also for a table's cell.
std::string escape_markdown(std::string_view text);

/// "1 run", "2 runs", or with a plural of its own "2 entries".
std::string counted(std::int64_t number, std::string_view noun, std::string_view plural = {});

/// A time with the unit µs, ms or s that gives it a number of at least 1.
std::string seconds_text(double seconds, int digits = 3);

/// Width of the text in pixels, by the advances of DejaVu Sans, the widest font that is usual;
/// fonts are the reader's. Characters beyond ASCII count as 0.65 of the size.
double text_width(const std::string& text, double size = 12);

/// Width of the widest of the texts; 0 if there is none.
double widest(const std::vector<std::string>& texts, double size = 12);

/// Returns the text, truncated with an ellipsis if there is no room.
std::string shortened(const std::string& text, double room, double size = 12);

/// The text in lines that have room, broken at spaces. A line of a single word may be wider.
std::vector<std::string> wrapped(const std::string& text, double room, double size = 12);

/// The text with a value in place of each {{name}}. Throws std::out_of_range for another name.
std::string with_slots(std::string_view text, const std::map<std::string, std::string>& values);

inline constexpr int usual_digits = 6;  ///< significant, that data.json keeps

/// The number with so many significant digits; whole numbers below 2^53 exactly; null if it is not
/// finite.
Json rounded(double number, int digits);

/// Returns the text of JSON with short lines, so that diffs are readable.
std::string json_text(const Json& data);

/// Parses JSON. Throws Json::exception if it is none, std::logic_error if it is nested too deeply.
Json data_in(const std::string& text);

}  // namespace ricochet::report
