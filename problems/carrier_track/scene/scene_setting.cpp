#include "problems/carrier_track/scene/scene_setting.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "problems/carrier_track/scene/scene_keys.h"
#include "ricochet/error.h"
#include "src/core/near_names.h"
#include "src/core/toml_text.h"

namespace ricochet::carrier_track::inline scene {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

/// The place that a setting names.
struct Place {
  std::string table, key;
};

/// Finds a key, with or without its table.
Place place_of(const std::string& name, const toml::table& file, const std::string& setting) {
  std::vector<Place> places;
  std::vector<std::string> known;
  for (const auto& [table, keys] : scene_keys()) {
    for (const std::string& key : keys) {
      known.push_back(key);
      const bool absent = table == "across" && !file.contains(table);
      if (name == table + "." + key || (name == key && !absent)) places.push_back({table, key});
    }
  }
  if (places.empty()) {
    const std::string key = name.substr(name.find('.') + 1);
    throw InputError(
        fmt::format("--set {}: there is no key {}; {}", setting, name, what_instead(key, known)));
  }
  if (places.size() > 1) {
    throw InputError(fmt::format("--set {}: {} is ambiguous: must be {}.{} or {}.{}", setting, name,
                                 places[0].table, name, places[1].table, name));
  }
  return places.front();
}

/// Removes the keys that say what `key` now says.
void remove_alternatives(toml::table& table, const std::string& key) {
  static const std::vector<std::pair<std::string, std::string>> alternatives = {
      {"path_radius", "centrifugal_mass_radius"},
      {"centrifugal_mass_radius", "path_radius"},
      {"revolutions", "seconds"},
      {"seconds", "revolutions"},
      {"counting_limit", "slowest"},
      {"restitution", "restitution_lower"},
      {"restitution", "restitution_upper"}};
  for (const auto& [set, other] : alternatives) {
    if (set == key) table.erase(other);
  }
  const bool one_wall = key == "restitution_lower" || key == "restitution_upper";
  const toml::node* both = table.get("restitution");
  if (!one_wall || both == nullptr) return;
  const toml::array* each = both->as_array();  // [lower, upper], as version 1 had it
  if (each == nullptr || each->size() == 2) {
    table.insert_or_assign("restitution_lower", each != nullptr ? *each->get(0) : *both);
    table.insert_or_assign("restitution_upper", each != nullptr ? *each->get(1) : *both);
  }
  table.erase("restitution");
}

/// Inserts the value as TOML, or, if it is none, as a text.
void assign(toml::table& table, const std::string& key, const std::string& value) {
  try {
    const toml::table parsed = parse_toml("value = " + value, "value");
    if (parsed.size() == 1) {
      table.insert_or_assign(key, *parsed.get("value"));
      return;
    }
  } catch (const InputError&) {  // such as 0.8 mm, without quotes
  }
  table.insert_or_assign(key, value);
}

}  // namespace

void apply_setting(toml::table& file, const std::string& setting) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos) {
    throw InputError(fmt::format("--set {}: must be KEY=VALUE", setting));
  }
  const Place place = place_of(trimmed(setting.substr(0, equals)), file, setting);
  if (!file.contains(place.table)) file.insert(place.table, toml::table());
  toml::table* table = file.get(place.table)->as_table();
  if (table == nullptr) return;  // reading the file says so
  remove_alternatives(*table, place.key);
  assign(*table, place.key, trimmed(setting.substr(equals + 1)));
}

}  // namespace ricochet::carrier_track::inline scene
