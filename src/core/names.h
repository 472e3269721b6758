#pragma once

#include <charconv>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <variant>
#include <vector>

namespace ricochet {

/// What is_name() allows, in words.
extern const std::string names_in_words;

/// Returns true for a name that can stand in lists, patterns, tables and names of files: 1 to 60
/// letters, digits and the characters - _ . +, of which the first is no dot.
bool is_name(std::string_view text);

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

/// The text as one line that is safe on a terminal: control characters, those of the
/// writing direction, line separators and invalid UTF-8 are written as \x1b, and of more than a few
/// thousand bytes the middle is left out.
std::string one_line(std::string_view text);

// Names chosen by patterns, as a shell chooses files (fnmatch).

bool fits(const std::string& name, const std::string& pattern);

bool fits_any(const std::string& name, const std::vector<std::string>& patterns);

/// The patterns of a comma-separated list.
std::vector<std::string> split_patterns(const std::string& list);

/// Throws InputError if no name matches any of the patterns: "`place` <patterns>: nothing fits",
/// with similar names, or else with `listing`, where they are listed, or else with all names.
void require_fit(const std::vector<std::string>& patterns, const std::vector<std::string>& names,
                 const std::string& place, const std::string& listing = "");

/// The value of a solver's option: a number or a word.
using OptionValue = std::variant<double, std::string>;

/// By name.
using GivenOptions = std::map<std::string, OptionValue>;

std::string text_of(const OptionValue& value);

/// A name or message as a label in tables for other programs. pandas.read_csv, pandas.read_json and
/// R take some texts for a missing value, even in quotes: "nan", the name of a perturbation,
/// becomes "missing-value", and the others, such as "NA", "null" and "None", get a ' before them.
/// An empty text stays empty: it is a missing value.
std::string label(std::string_view text);

/// The number that the text is, as C++ writes it, without blanks and without a plus; nothing if the
/// text is anything else or does not fit the type.
template <class Number>
std::optional<Number> number_of_text(std::string_view text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return number;
}

}  // namespace ricochet
