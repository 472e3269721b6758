#include "problems/carrier_track/scene/toml_table.h"

#include <algorithm>
#include <sstream>

#include "ricochet/error.h"
#include "src/core/near_names.h"
#include "src/core/warning.h"

namespace ricochet::carrier_track::inline scene {
TomlTable::TomlTable(const toml::table& file, std::string name, std::string origin)
    : name_(std::move(name)), origin_(std::move(origin)) {
  if (const toml::table* table = file[name_].as_table()) table_ = *table;
}

bool TomlTable::has(std::string_view key) {
  know(key);
  return table_ && table_->contains(key);
}

void TomlTable::know_walls(std::string_view key) {
  for (const char* wall : {"", "_lower", "_upper"}) know(fmt::format("{}{}", key, wall));
}

void TomlTable::need(std::string_view key) {
  if (!has(key)) throw InputError(fmt::format("{}: {}.{} is missing", origin_, name_, key));
}

void TomlTable::number(std::string_view key, double& target) {
  if (!has(key)) return;
  target = number_of(key, *table_->get(key), "a number");
}

void TomlTable::boolean(std::string_view key, bool& target) {
  if (!has(key)) return;
  const toml::node& node = *table_->get(key);
  if (!node.is_boolean()) refuse(key, node, "true or false");
  target = node.as_boolean()->get();
}

void TomlTable::renamed(std::string_view old_key, std::string_view key) {
  if (table_) rename_key(*table_, old_key, key, fmt::format("{}: {}.", origin_, name_));
}

void TomlTable::walls(std::string_view key, double& lower, double& upper) {
  const std::string lower_key = fmt::format("{}_lower", key);
  const std::string upper_key = fmt::format("{}_upper", key);
  const bool of_each = has(lower_key) || has(upper_key);
  if (of_each == has(key)) {
    throw InputError(fmt::format("{}: {}.{} {}; give {} for both walls, or {} and {}", origin_,
                                 name_, key, of_each ? "is given twice" : "is missing", key,
                                 lower_key, upper_key));
  }
  if (of_each) {
    need(lower_key);
    need(upper_key);
    number(lower_key, lower);
    number(upper_key, upper);
    return;
  }
  constexpr const char* allowed = "a number, or [lower, upper]";
  const toml::node& node = *table_->get(key);
  const toml::array* array = node.as_array();
  if (array == nullptr) {
    lower = upper = number_of(key, node, allowed);
    return;
  }
  if (array->size() != 2) refuse(key, node, allowed);
  warn(fmt::format("{}: {}.{} = [lower, upper] is now written as {} and {}", origin_, name_, key,
                   lower_key, upper_key));
  lower = number_of(key, *array->get(0), allowed);
  upper = number_of(key, *array->get(1), allowed);
}

void TomlTable::number_or(std::string_view key, std::string_view none,
                          std::optional<double>& target) {
  if (!has(key)) return;
  const toml::node& node = *table_->get(key);
  if (node.is_string() && node.as_string()->get() == none) {
    target.reset();
  } else {
    target = number_of(key, node, fmt::format("a number, or \"{}\"", none));
  }
}

void TomlTable::number_or_knots(std::string_view key, double& target,
                                std::vector<SpeedKnot<double>>& knots) {
  constexpr const char* allowed = "a number, or [[time, omega], ...]";
  if (!has(key)) return;
  const toml::node& node = *table_->get(key);
  const toml::array* array = node.as_array();
  if (array == nullptr) {
    target = number_of(key, node, allowed);
    return;
  }
  if (array->empty()) refuse(key, node, allowed);
  for (const toml::node& element : *array) {
    const toml::array* knot = element.as_array();
    if (knot == nullptr || knot->size() != 2) refuse(key, node, allowed);
    knots.push_back(
        {number_of(key, *knot->get(0), allowed), number_of(key, *knot->get(1), allowed)});
  }
}

void TomlTable::finish() const {
  if (!table_) return;
  for (const auto& [key, node] : *table_) {
    if (known_.contains(std::string(key.str()))) continue;
    throw InputError(fmt::format("{}: there is no key {}.{}; {}", origin_, name_, key.str(),
                                 what_instead(key.str(), {known_.begin(), known_.end()})));
  }
}

double TomlTable::number_of(std::string_view key, const toml::node& node,
                            std::string_view allowed) const {
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value) refuse(key, node, allowed);
  return *value;
}

void TomlTable::refuse(std::string_view key, const toml::node& node,
                       std::string_view allowed) const {
  std::ostringstream text;
  node.visit([&text](const auto& shown) { text << shown; });
  throw InputError(
      fmt::format("{}: {}.{} = {}: must be {}", origin_, name_, key, text.str(), allowed));
}

}  // namespace ricochet::carrier_track::inline scene
