#include "src/core/toml_fields.h"

#include <cmath>

#include "ricochet/error.h"

namespace ricochet {

void TomlTable::refuse_others_than(const std::vector<std::string>& known) const {
  const auto is_known = [&](std::string_view key) {
    return std::find(known.begin(), known.end(), key) != known.end();
  };
  if (table_ == nullptr || is_known(other_keys)) return;
  for (const auto& [key, node] : *table_) {
    if (is_known(key.str())) continue;
    throw InputError(fmt::format("{}: there is no key {}; {}", place_, named(key.str()),
                                 what_instead(key.str(), known)));
  }
}

void TomlTable::need(std::string_view key) const {
  if (!has(key)) throw InputError(fmt::format("{}: {} is missing", place_, named(key)));
}

void TomlTable::refuse(std::string_view key, const toml::node& value,
                       std::string_view allowed) const {
  throw InputError(
      fmt::format("{}: {} = {}: must be {}", place_, named(key), toml_value(value), allowed));
}

TomlTable table_in(const TomlValue& value) {
  const toml::table* table = value.node.as_table();
  if (table == nullptr) value.refuse("a table");
  return {table, fmt::format("{}, {}", value.in.place(), value.field.key)};
}

double number_in(const TomlValue& value, std::string_view others) {
  std::optional<double> number;
  if (value.node.is_number()) number = value.node.value<double>();
  if (value.node.is_string()) {
    number = quantity(value.node.as_string()->get(), value.field.unit);
  }
  if (!number) value.refuse(numbers_in_words(value.field.unit) + std::string(others));
  return *number;
}

namespace {

std::string allowed_by(const Field& field) {
  return field.range == Range{} ? numbers_in_words(field.unit) : in_words(field.range, field.unit);
}

}  // namespace

void read_value(const TomlValue& value, double& target) {
  const Field& field = value.field;
  const bool may_be_number = value.node.is_number() || value.node.is_string();
  if (!may_be_number) value.refuse(allowed_by(field));
  const double number = number_in(value);
  if (!contains(field.range, number)) value.refuse(allowed_by(field));
  target = number;
}

void read_value(const TomlValue& value, std::int64_t& target) {
  const auto number = value.node.is_integer() ? value.node.value<std::int64_t>() : std::nullopt;
  if (!number || !contains(value.field.range, static_cast<double>(*number))) {
    value.refuse(in_words(value.field.range));
  }
  target = *number;
}

void read_value(const TomlValue& value, int& target) {
  std::int64_t number = 0;
  read_value(value, number);
  target = static_cast<int>(number);
}

void read_value(const TomlValue& value, bool& target) {
  if (!value.node.is_boolean()) value.refuse("true or false");
  target = value.node.as_boolean()->get();
}

void read_value(const TomlValue& value, std::string& target) {
  if (!value.node.is_string()) value.refuse("a text");
  target = value.node.as_string()->get();
  const bool must_say_something = value.is_entry || value.field.presence == Presence::required;
  if (target.empty() && must_say_something) value.refuse("a text that is not empty");
}

void read_value(const TomlValue& value, Name<std::string> target) {
  if (!value.node.is_string()) value.refuse("a text");
  target.text = value.node.as_string()->get();
  if (!is_name(target.text)) value.refuse(names_in_words);
}

void read_value(const TomlValue& value, OptionValue& target) {
  const auto number = value.node.is_number() ? value.node.value<double>() : std::nullopt;
  if (number && std::isfinite(*number)) {
    target = *number + 0.0;  // no -0
  } else if (value.node.is_string() && !value.node.as_string()->get().empty()) {
    target = value.node.as_string()->get();
  } else {
    value.refuse("a finite number or a text");
  }
}

void read_value(const TomlValue& value, Vector& target) {
  const toml::array* list = value.node.as_array();
  if (list == nullptr) value.refuse("a list of numbers");
  target.resize(static_cast<Eigen::Index>(list->size()));
  double* x = target.data();
  for (const toml::node& entry : *list) read_value(value.entry(entry), *x++);
}

std::string toml_text(double x) {
  return toml_float(x);
}

std::string toml_text(std::int64_t x) {
  return fmt::format("{}", x);
}

std::string toml_text(bool x) {
  return x ? "true" : "false";
}

// In one line. The output of toml++ cannot always be read back.
std::string toml_text(const std::string& text) {
  std::string basic = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') basic += '\\';
    basic += code < 0x20 || code == 0x7F ? fmt::format("\\u{:04X}", code) : std::string(1, c);
  }
  return basic + '"';
}

std::string toml_text(const OptionValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? toml_text(*number) : toml_text(std::get<std::string>(value));
}

std::string toml_text(const Vector& x) {
  return toml_list(x);
}

}  // namespace ricochet
