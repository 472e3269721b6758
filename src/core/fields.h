#pragma once

#include <algorithm>
#include <concepts>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// The list of a struct's fields. A struct names its fields once, in a function beside it,
///
///   template <class Visit, IsOf<Limits>... L>
///   void visit_fields(const Visit& visit, L&... l) {
///     visit(Field{"seconds", "s", "of one run", positive_number}, l.seconds...);
///   }
///
/// which calls `visit` with the description of each field and its member in each of the given
/// objects. Whatever depends on the fields of the struct uses that list: toml_fields.h reads and
/// writes files by it, json_fields.h JSON, and tests compare it with the tables in the documents.
namespace ricochet {

/// The allowed values of a number.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool without_least = false, without_most = false;  ///< the bound itself is excluded
  bool whole = false;
  std::string_view brief = "";  ///< as tables of keys have it: "> 0"
  std::string_view words = "";  ///< as a refusal has it, {} being the unit; else see in_words()

  bool operator==(const Range&) const = default;
};

/// A range without bounds contains everything, NaN, too.
bool contains(const Range& range, double x);

/// E.g. "a whole number from 1 to 1000000", or "a number from 0 to 1, but not 0".
std::string in_words(const Range& range, std::string_view unit = "");

inline constexpr Range positive_number{.least = 0,
                                       .most = std::numeric_limits<double>::max(),
                                       .without_least = true,
                                       .brief = "> 0",
                                       .words = "a finite number > 0"};

constexpr Range whole_number(double least, double most = 1e6) {
  return {.least = least, .most = most, .whole = true};
}

/// Whether a file must give a field. What is stated may be left out, but is always written.
enum class Presence { optional, stated, required };

/// How the entries of a list differ.
enum class Entries { any, distinct, rising };

/// The key of a field that has all those of its table that no other field has.
inline constexpr std::string_view other_keys = "*";

/// The description of a field.
struct Field {
  std::string_view key;
  std::string_view unit = "";              ///< "1" for a number without unit, "" if not a number
  std::string_view remark = "";            ///< its meaning, as a written file has it
  Range range = {};                        ///< of a number, or of each in a list
  Presence presence = Presence::optional;  ///< if optional, the default is that of the struct
  Entries entries = Entries::any;
};

/// S or const S.
template <class T, class S>
concept IsOf = std::same_as<std::remove_const_t<T>, S>;

struct NoVisit {
  template <class... Members>
  void operator()(const Field& /*field*/, Members&&... /*members*/) const {}
};

/// A struct with a list of its fields.
template <class T>
concept HasFields = std::is_class_v<T> && requires(T& value) {
  visit_fields(NoVisit{}, value);
};

/// The keys of a struct's fields, in the order of its list.
template <HasFields T>
std::vector<std::string> keys_of() {
  std::vector<std::string> keys;
  const T value{};
  visit_fields([&](const Field& field, const auto& /*member*/) { keys.emplace_back(field.key); },
               value);
  return keys;
}

/// A text that is a name, see is_name().
template <class Text>
struct Name {
  Text& text;

  bool operator==(const Name& other) const { return text == other.text; }
};
template <class Text>
Name(Text&) -> Name<Text>;

/// The values of an enumeration and their names in files and options. names_of(value), beside an
/// enumeration, returns its list.
template <class Value>
using EnumNames = std::vector<std::pair<std::string_view, Value>>;

template <class T>
concept HasNames = std::is_enum_v<T> && requires(T value) {
  names_of(value);
};

/// Throws std::logic_error for a value without a name.
template <class Value>
std::string_view name_of(const EnumNames<Value>& choices, Value value) {
  const auto named = std::find_if(choices.begin(), choices.end(),
                                  [&](const auto& choice) { return choice.second == value; });
  if (named == choices.end()) throw std::logic_error("a value without a name");
  return named->first;
}

/// The units in which a text may give a number whose SI unit is `unit`: "m", "cm", "mm" for "m".
/// Empty for a number without a unit, and for units that depend on other numbers.
std::vector<std::string_view> units_for(std::string_view unit);

/// The number [unit] that a text gives: a number and one of units_for(unit), with or without a
/// blank between. "0.8 mm" is 0.0008 for "m". Returns nothing for any other text.
std::optional<double> quantity(std::string_view text, std::string_view unit);

/// "a number", with the units that a text may have.
std::string numbers_in_words(std::string_view unit);

}  // namespace ricochet
