#pragma once

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "ricochet/problem.h"
#include "src/core/fields.h"
#include "src/core/names.h"
#include "src/core/toml.h"

/// Reads structs from TOML, and writes them, by the lists of their fields (fields.h).
namespace ricochet {

/// A table of a TOML file with its place in it, with which all its messages begin: "plan.toml:3,
/// part 1: instances = 0: must be a whole number from 1 to 1000000".
class TomlTable {
 public:
  /// Messages name a key with `prefix` before it: "scene." for scene.mass. A null table has no key.
  TomlTable(const toml::table* table, std::string place, std::string prefix = "")
      : table_(table), place_(std::move(place)), prefix_(std::move(prefix)) {}

  bool exists() const { return table_ != nullptr; }
  bool has(std::string_view key) const { return find(key) != nullptr; }
  const toml::node* find(std::string_view key) const {
    return table_ != nullptr ? table_->get(key) : nullptr;
  }
  const toml::table& table() const { return *table_; }
  const std::string& place() const { return place_; }
  std::string named(std::string_view key) const { return fmt::format("{}{}", prefix_, key); }

  /// Throws InputError for a key that is not one of these; with other_keys among them for none.
  void refuse_others_than(const std::vector<std::string>& known) const;

  /// Throws InputError if the key is missing.
  void need(std::string_view key) const;

  /// Throws InputError: the value of the key must be something else.
  [[noreturn]] void refuse(std::string_view key, std::string_view allowed) const {
    refuse(key, *find(key), allowed);
  }
  [[noreturn]] void refuse(std::string_view key, const toml::node& value,
                           std::string_view allowed) const;

 private:
  const toml::table* table_;
  std::string place_, prefix_;
};

/// A value in a table, or an entry of a list there, with the field that it is of. read_value() of
/// each type throws InputError for a value that is not one.
struct TomlValue {
  const toml::node& node;
  const Field& field;
  const TomlTable& in;
  bool is_entry = false;  ///< of a list

  TomlValue entry(const toml::node& of_list) const { return {of_list, field, in, true}; }
  [[noreturn]] void refuse(std::string_view allowed) const { in.refuse(field.key, node, allowed); }
};

/// A table within a table, with its place.
TomlTable table_in(const TomlValue& value);

/// A number, or a text with a unit of the field's; `others` says what else the key may have.
double number_in(const TomlValue& value, std::string_view others = "");

void read_value(const TomlValue& value, double& target);
void read_value(const TomlValue& value, std::int64_t& target);
void read_value(const TomlValue& value, int& target);
void read_value(const TomlValue& value, bool& target);
void read_value(const TomlValue& value, std::string& target);
void read_value(const TomlValue& value, Name<std::string> target);
void read_value(const TomlValue& value, OptionValue& target);
void read_value(const TomlValue& value, Vector& target);

template <HasNames Enum>
void read_value(const TomlValue& value, Enum& target) {
  std::string allowed;
  for (const auto& [name, choice] : names_of(target)) {
    if (value.node.is_string() && value.node.as_string()->get() == name) {
      target = choice;
      return;
    }
    allowed += fmt::format("{}\"{}\"", allowed.empty() ? "" : " or ", name);
  }
  value.refuse(allowed);
}

template <class T>
void read_value(const TomlValue& value, std::optional<T>& target) {
  read_value(value, target.emplace());
}

/// One entry or a list of them; empty only if the default is and the field may be left out.
template <class T, class Read>
void read_list(const TomlValue& value, std::vector<T>& target, const Read& read) {
  const bool may_be_empty = target.empty() && value.field.presence != Presence::required;
  target.clear();
  if (const toml::array* list = value.node.as_array()) {
    for (const toml::node& entry : *list) read(value.entry(entry), target.emplace_back());
  } else {
    read(value, target.emplace_back());
  }
  if (target.empty() && !may_be_empty) value.refuse("a list of one or more");
  if (value.field.entries == Entries::any) return;
  std::vector<T> sorted = target;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
    value.refuse("a list without repetitions");
  }
  if (value.field.entries == Entries::rising && sorted != target) value.refuse("rising");
}

template <class T>
void read_value(const TomlValue& value, std::vector<T>& target) {
  read_list(value, target, [](const TomlValue& entry, T& x) { read_value(entry, x); });
}

/// A list of exactly as many.
template <class T, std::size_t size>
void read_value(const TomlValue& value, std::array<T, size>& target) {
  std::vector<T> list;
  read_value(value, list);
  if (list.size() != size) value.refuse(fmt::format("a list of {}", size));
  std::copy(list.begin(), list.end(), target.begin());
}

template <class T>
inline constexpr bool is_map = false;
template <class T>
inline constexpr bool is_map<std::map<std::string, T>> = true;

/// Reads the fields of a table, each according to its type.
struct FieldReader {
  const TomlTable& table;
  std::vector<std::string> keys = {};  ///< of the struct, for what has the other keys

  template <class T>
  void operator()(const Field& field, T&& target) const {
    if constexpr (is_map<std::remove_cvref_t<T>>) {
      if (field.key == other_keys) return read_others(field, target);
    }
    if (field.presence == Presence::required) table.need(field.key);
    const toml::node* node = table.find(field.key);
    if (node != nullptr) read_value(TomlValue{*node, field, table}, target);
  }

 private:
  template <class T>
  void read_others(const Field& field, std::map<std::string, T>& target) const {
    for (const auto& [key, node] : table.table()) {
      if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
      Field each = field;
      each.key = key.str();
      each.presence = Presence::required;
      read_value(TomlValue{node, each, table}, target[std::string(key.str())]);
    }
  }
};

/// A table within a table, whose keys are free.
template <class T>
void read_value(const TomlValue& value, std::map<std::string, T>& target) {
  FieldReader{table_in(value)}(Field{other_keys}, target);
}

/// Reads a struct's fields; those that the table has not keep their values. A struct may have
/// rules beyond those of its fields, in a function check_fields(const TomlTable&, const T&).
template <HasFields T>
void read_fields(const TomlTable& table, T& target) {
  const FieldReader reader{table, keys_of<T>()};
  table.refuse_others_than(reader.keys);
  visit_fields(reader, target);
  if constexpr (requires { check_fields(table, target); }) check_fields(table, target);
}

template <HasFields T>
T fields_from(const TomlTable& table) {
  T value{};
  read_fields(table, value);
  return value;
}

/// The struct in a TOML text. Throws InputError, which names the text `origin`.
template <HasFields T>
T fields_from(const std::string& text, const std::string& origin) {
  const toml::table file = parse_toml(text, origin);
  return fields_from<T>(TomlTable(&file, origin));
}

/// A table within a table.
template <HasFields T>
void read_value(const TomlValue& value, T& target) {
  read_fields(table_in(value), target);
}

/// Tables [[key]].
template <HasFields T>
void read_value(const TomlValue& value, std::vector<T>& target) {
  const toml::array* tables = value.node.as_array();
  if (tables == nullptr || !tables->is_array_of_tables() || tables->empty()) {
    value.refuse(fmt::format("one or more tables [[{}]]", value.field.key));
  }
  for (const toml::node& node : *tables) {
    const std::string place =
        fmt::format("{}:{}, {} {}", value.in.place(), node.source().begin.line, value.field.key,
                    target.size() + 1);
    target.push_back(fields_from<T>(TomlTable(node.as_table(), place)));
  }
}

// Values as TOML writes them, in one line.

std::string toml_text(double x);
std::string toml_text(std::int64_t x);
std::string toml_text(bool x);
std::string toml_text(const std::string& text);
std::string toml_text(const OptionValue& value);
std::string toml_text(const Vector& x);
inline std::string toml_text(int x) {
  return toml_text(std::int64_t{x});
}
template <class Text>
std::string toml_text(Name<Text> name) {
  return toml_text(name.text);
}
template <HasNames Enum>
std::string toml_text(Enum x) {
  return fmt::format("\"{}\"", name_of(names_of(x), x));
}
template <class T>
std::string toml_text(const std::optional<T>& x) {
  return toml_text(x.value());
}
template <class List>
std::string toml_list(const List& list) {
  std::string text;
  for (const auto& entry : list) text += (text.empty() ? "" : ", ") + toml_text(entry);
  return "[" + text + "]";
}
template <class T>
requires(!HasFields<T>) std::string toml_text(const std::vector<T>& list) {
  return toml_list(list);
}
template <class T, std::size_t size>
std::string toml_text(const std::array<T, size>& list) {
  return toml_list(list);
}

/// Entries of a table in one line: "x" = 1.0, "y" = 2.0.
template <class T>
std::string toml_entries(const std::map<std::string, T>& map) {
  std::string text;
  for (const auto& [key, value] : map) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", toml_text(key), toml_text(value));
  }
  return text;
}
template <class T>
requires(!HasFields<T>) std::string toml_text(const std::map<std::string, T>& map) {
  return fmt::format("{{ {} }}", toml_entries(map));
}

template <class T>
bool are_equal(const T& a, const T& b) {
  if constexpr (requires { a.size(); }) {
    if (a.size() != b.size()) return false;  // Eigen compares vectors of one length only
  }
  return a == b;
}

/// Writes the fields of a struct, each on a line of its own, but for optional ones that are as in
/// `usual`. Structs become tables, which must come last in a list; a struct with a toml_text() of
/// its own is a value like any other.
struct FieldWriter {
  std::string& text;

  template <class T>
  void operator()(const Field& field, const T& value, const T& usual) const {
    if constexpr (requires { toml_text(value); }) {
      if (field.presence != Presence::optional || !are_equal(value, usual)) {
        text += fmt::format("{} = {}\n", field.key, toml_text(value));
      }
    } else if constexpr (HasFields<T>) {
      table(fmt::format("[{}]", field.key), value);
    } else if constexpr (is_map<T>) {
      for (const auto& [key, each] : value) table(fmt::format("[{}]", key), each);
    } else {
      for (const auto& each : value) table(fmt::format("[[{}]]", field.key), each);
    }
  }

 private:
  template <class T>
  void table(const std::string& head, const T& value) const {
    text += fmt::format("\n{}\n", head);
    const T usual{};
    visit_fields(*this, value, usual);
  }
};

/// TOML text that reads back to the same struct, bit for bit.
template <HasFields T>
std::string toml_of_fields(const T& value) {
  std::string text;
  const T usual{};
  visit_fields(FieldWriter{text}, value, usual);
  return text;
}

}  // namespace ricochet
