#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/report/chart.h"
#include "src/report/json.h"

namespace ricochet::report {

/// Escapes text as content of an HTML or XML element or of a quoted attribute. Control characters,
/// which XML forbids, become spaces.
std::string escape_html(std::string_view text);

/// Escapes text as inline Markdown, also for a table's cell.
std::string escape_markdown(std::string_view text);

/// Like escape_html, and turns every https:// address into a link.
std::string html_with_links(std::string_view text);

/// Formats the value with fmt's `form`, such as "{:.2f}"; a dash if it is missing.
template <class T>
std::string text_or_dash(const std::optional<T>& value, const char* form) {
  return value ? fmt::format(fmt::runtime(form), *value) : "–";
}

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

/// Where the cells of a heat map lead: to a folder, #, and what stands in the link for the row and
/// for the column, joined. In the order of the chart's axes; empty: nowhere.
struct CellLinks {
  std::vector<std::string> rows, columns;
};

/// What reports/templates/chart_links.js needs: `box`, the pixels of the cells in the picture
/// (left, right, top, bottom), and for each of the `rows`, from the top, and `columns` its name and
/// its part of the address.
Json cell_links_data(const Chart& chart, const CellLinks& links);

/// The text with a value in place of each {{name}}. Throws std::out_of_range for another name.
std::string with_slots(std::string_view text, const std::map<std::string, std::string>& values);

/// Data in which a template looks up a name, from the last to the first.
using Scopes = std::vector<const Json*>;

/// Returns the data of a name: "name", "table.name", or "." for the innermost scope itself. Throws
/// std::logic_error if no scope has it.
const Json& found_in(const Scopes& scopes, const std::string& name);

/// Returns true if a template's condition holds for the data: unless they are null, false, "" or an
/// empty list. Zero counts as true.
bool is_yes(const Json& data);

/// Fills in a Mustache text. {{name:format}} formats as fmt's {:format} does; for a share, a format
/// that ends in % gives per cent. Null becomes a dash, and a number that rounds to zero has no
/// sign. {{#name}}...{{/name}} is included if the data are true, once for each entry of a list;
/// {{^name}}...{{/name}} if they are not. The name @first is true in the first entry of a list, so
/// that {{^@first}}, {{/@first}} separates entries; @last in the last. Nothing is escaped. Throws
/// std::logic_error if the text is not valid Mustache, or if a name has no data.
std::string filled(const std::string& text, const Scopes& scopes);

/// Number of significant digits that are kept, by the name of the number in the data.
using Digits = std::map<std::string, int, std::less<>>;

/// Returns the text of a report's data.json: lists of records as tables, see packed; numbers with a
/// fraction rounded to `usual_digits` significant digits or those for their name; whole numbers
/// below 2^53, and texts, exactly. Lines are kept short, so that diffs are readable.
std::string data_text(const Json& data, const Digits& digits = {});
inline constexpr int usual_digits = 6;

/// The number with as many significant digits as data.json keeps; whole numbers below 2^53 exactly;
/// null if it is not finite.
Json rounded(double number, int digits);

/// Returns the text of JSON with short lines, so that diffs are readable.
std::string json_text(const Json& data);

/// Parses such a text, or any JSON. Throws Json::exception if it is not JSON.
Json data_in(const std::string& text);

}  // namespace ricochet::report
