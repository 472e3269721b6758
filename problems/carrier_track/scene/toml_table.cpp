#include "problems/carrier_track/scene/toml_table.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "ricochet/error.h"
#include "src/core/names.h"
#include "src/core/progress.h"
#include "src/core/toml.h"

namespace ricochet::carrier_track::inline scene {

namespace {

/// "a number", with the units that a text may have.
std::string numbers_in_words(const Field& field) {
  const std::vector<std::string_view> units = units_for(field.unit);
  if (units.empty()) return "a number";
  return fmt::format("a number [{}], or a text such as \"1 {}\" with a unit of {}", field.unit,
                     units.back(), fmt::join(units, ", "));
}

}  // namespace

TomlTable::TomlTable(const toml::table& file, std::string name, std::string origin,
                     Uncertain& uncertain)
    : name_(std::move(name)), origin_(std::move(origin)), uncertain_(uncertain) {
  if (const toml::table* table = file[name_].as_table()) table_ = *table;
}

void TomlTable::refuse_others_than(const std::vector<std::string>& known) const {
  if (!table_) return;
  for (const auto& [key, node] : *table_) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    throw InputError(fmt::format("{}: there is no key {}.{}; {}", origin_, name_, key.str(),
                                 what_instead(key.str(), known)));
  }
}

void TomlTable::need(std::string_view key) const {
  if (!has(key)) throw InputError(fmt::format("{}: {}.{} is missing", origin_, name_, key));
}

void TomlTable::number(const Field& field, double& target) {
  if (!has(field.key)) return;
  target = number_of(field, *table_->get(field.key));
}

void TomlTable::boolean(std::string_view key, bool& target) const {
  if (!has(key)) return;
  const toml::node& node = *table_->get(key);
  if (!node.is_boolean()) refuse(key, node, "true or false");
  target = node.as_boolean()->get();
}

void TomlTable::renamed(std::string_view old_key, std::string_view key) {
  if (table_) rename_key(*table_, old_key, key, fmt::format("{}: {}.", origin_, name_));
}

void TomlTable::walls(const Field& field, double& lower, double& upper) {
  const std::string lower_key = fmt::format("{}_lower", field.key);
  const std::string upper_key = fmt::format("{}_upper", field.key);
  const bool of_each = has(lower_key) || has(upper_key);
  if (of_each == has(field.key)) {
    throw InputError(fmt::format("{}: {}.{} {}; give {} for both walls, or {} and {}", origin_,
                                 name_, field.key, of_each ? "is given twice" : "is missing",
                                 field.key, lower_key, upper_key));
  }
  if (of_each) {
    need(lower_key);
    need(upper_key);
    number({lower_key, field.unit}, lower);
    number({upper_key, field.unit}, upper);
    return;
  }
  constexpr const char* others = ", or [lower, upper]";
  const toml::node& node = *table_->get(field.key);
  const toml::array* array = node.as_array();
  if (array == nullptr) {
    lower = upper = number_of(field, node, others);
    return;
  }
  if (array->size() != 2) refuse(field.key, node, "a number, or [lower, upper]");
  lower = number_of(field, *array->get(0), others);
  upper = number_of(field, *array->get(1), others);
  warn(fmt::format("{}: {}.{} = [lower, upper] is now written as {} and {}", origin_, name_,
                   field.key, lower_key, upper_key));
}

void TomlTable::number_or(const Field& field, std::string_view none,
                          std::optional<double>& target) {
  if (!has(field.key)) return;
  const toml::node& node = *table_->get(field.key);
  if (node.is_string() && node.as_string()->get() == none) {
    target.reset();
  } else {
    target = number_of(field, node, fmt::format(", or \"{}\"", none));
  }
}

void TomlTable::number_or_knots(const Field& field, double& target,
                                std::vector<SpeedKnot<double>>& knots) {
  constexpr const char* others = ", or [[time, omega], ...]";
  if (!has(field.key)) return;
  const toml::node& node = *table_->get(field.key);
  const toml::array* array = node.as_array();
  if (array == nullptr) {
    target = number_of(field, node, others);
    return;
  }
  const std::string allowed = "a number" + std::string(others);
  if (array->empty()) refuse(field.key, node, allowed);
  const Field time{field.key, "s"};
  for (const toml::node& element : *array) {
    const toml::array* knot = element.as_array();
    if (knot == nullptr || knot->size() != 2) refuse(field.key, node, allowed);
    const double at = certain_number_of(time, *knot->get(0), others);
    knots.push_back({at, certain_number_of(field, *knot->get(1), others)});
  }
}

/// Reads a number in any of its forms. `others` is what else the key may have, for the error.
double TomlTable::number_of(const Field& field, const toml::node& node, std::string_view others) {
  const toml::table* table = node.as_table();
  if (table == nullptr) return certain_number_of(field, node, others);
  const toml::node* value = table->get("value");
  const toml::node* plus_minus = table->get("plus_minus");
  if (value == nullptr || plus_minus == nullptr || table->size() != 2) {
    refuse(field.key, node, "a number, or {value = NUMBER, plus_minus = NUMBER}");
  }
  const double middle = certain_number_of(field, *value, "");
  const double width = certain_number_of(field, *plus_minus, "");
  if (!(width > 0 && std::isfinite(width) && std::isfinite(middle))) {
    throw InputError(fmt::format(
        "{}: {}.{} = {{value = {}, plus_minus = {}}}: must be finite numbers, and plus_minus > 0",
        origin_, name_, field.key, middle, width));
  }
  const std::size_t index = uncertain_.found.size();
  uncertain_.found.push_back(
      {fmt::format("{}.{}", name_, field.key), middle, width, std::string(field.unit)});
  return uncertain_.shares.empty() ? middle : middle + uncertain_.shares[index] * width;
}

double TomlTable::certain_number_of(const Field& field, const toml::node& node,
                                    std::string_view others) const {
  std::optional<double> value;
  if (node.is_number()) value = node.value<double>();
  if (node.is_string()) value = quantity(node.as_string()->get(), field.unit);
  if (!value) refuse(field.key, node, numbers_in_words(field) + std::string(others));
  return *value;
}

void TomlTable::refuse(std::string_view key, const toml::node& node,
                       std::string_view allowed) const {
  throw InputError(
      fmt::format("{}: {}.{} = {}: must be {}", origin_, name_, key, toml_value(node), allowed));
}

namespace {

/// A number x of `name` is x * times / over of the unit `of`. Two factors, because dividing by 1000
/// rounds once, and multiplying by 0.001 twice.
struct Unit {
  std::string_view of, name;
  double times, over;
};

constexpr double pi = std::numbers::pi;

/// The units of every dimension; the first of each is the SI unit itself.
constexpr Unit units[] = {
    {"kg", "kg", 1, 1},       {"kg", "g", 1, 1e3},         {"m", "m", 1, 1},
    {"m", "mm", 1, 1e3},      {"m", "cm", 1, 1e2},         {"m", "um", 1, 1e6},
    {"m/s", "m/s", 1, 1},     {"m/s", "mm/s", 1, 1e3},     {"m/s", "cm/s", 1, 1e2},
    {"N", "N", 1, 1},         {"N", "mN", 1, 1e3},         {"N", "kN", 1e3, 1},
    {"s", "s", 1, 1},         {"s", "ms", 1, 1e3},         {"s", "min", 60, 1},
    {"rad", "rad", 1, 1},     {"rad", "deg", pi, 180},     {"rad/s", "rad/s", 1, 1},
    {"rad/s", "rpm", pi, 30}, {"rad/s", "deg/s", pi, 180}, {"rad/s", "Hz", 2 * pi, 1},
    {"kg m", "kg m", 1, 1},   {"kg m", "kg mm", 1, 1e3},   {"kg m", "g m", 1, 1e3},
    {"kg m", "g mm", 1, 1e6}};

}  // namespace

std::vector<std::string_view> units_for(std::string_view unit) {
  std::vector<std::string_view> names;
  for (const Unit& known : units) {
    if (known.of == unit) names.push_back(known.name);
  }
  return names;
}

std::optional<double> quantity(std::string_view text, std::string_view unit) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  const std::size_t blanks = text.find_first_not_of(' ');
  if (blanks == std::string_view::npos) return std::nullopt;
  const std::string_view wanted = text.substr(blanks);
  for (const Unit& known : units) {
    if (known.of == unit && known.name == wanted) return number * known.times / known.over;
  }
  return std::nullopt;
}

}  // namespace ricochet::carrier_track::inline scene
