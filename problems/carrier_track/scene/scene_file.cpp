#include "problems/carrier_track/scene/scene_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "ricochet/error.h"
#include "ricochet/scene.h"
#include "src/core/fields.h"
#include "src/core/names.h"
#include "src/core/progress.h"
#include "src/core/toml_fields.h"

namespace ricochet::carrier_track::inline scene {

namespace {

/// The uncertain numbers of a file, in the order in which they are read.
struct Uncertain {
  std::span<const double> shares = {};  ///< where each is read, see SceneFile; empty: at its value
  std::vector<Uncertainty> found = {};  ///< those read so far
};

/// Reads the fields of a table. A number may be a table {value = ..., plus_minus = ...}, too. That
/// numbers are within their ranges, check() sees to.
struct SceneReader {
  TomlTable table;
  Uncertain& uncertain;

  TomlValue value_of(const SceneField& field) const {
    return {*table.find(field.key), field, table};
  }
  double number(const SceneField& field, std::string_view others = "") const {
    return number(value_of(field), others);
  }

  /// A number in any of its forms; `others` says what else the key may have.
  double number(const TomlValue& given, std::string_view others) const {
    const toml::table* range = given.node.as_table();
    if (range == nullptr) return number_in(given, others);
    const toml::node* value = range->get("value");
    const toml::node* plus_minus = range->get("plus_minus");
    if (value == nullptr || plus_minus == nullptr || range->size() != 2) {
      given.refuse("a number, or {value = NUMBER, plus_minus = NUMBER}");
    }
    const double middle = number_in(given.entry(*value));
    const double width = number_in(given.entry(*plus_minus));
    if (!(width > 0 && std::isfinite(width) && std::isfinite(middle))) {
      throw InputError(fmt::format(
          "{}: {} = {{value = {}, plus_minus = {}}}: must be finite numbers, and plus_minus > 0",
          table.place(), table.named(given.field.key), middle, width));
    }
    const std::size_t index = uncertain.found.size();
    uncertain.found.push_back(
        {table.named(given.field.key), middle, width, std::string(given.field.unit)});
    return uncertain.shares.empty() ? middle : middle + uncertain.shares[index] * width;
  }

  void operator()(const SceneField& field, double& x) const {
    if (field.presence == Presence::required) table.need(field.key);
    if (table.has(field.key)) x = number(field);
  }

  /// One number for both walls under the key, or one for each under key_lower and key_upper;
  /// required. An array of two under the key, as version 1 had it, is read with a warning.
  void operator()(const SceneField& field, Walls<double> x) const {
    const std::string lower_key = fmt::format("{}_lower", field.key);
    const std::string upper_key = fmt::format("{}_upper", field.key);
    const bool of_each = table.has(lower_key) || table.has(upper_key);
    if (of_each == table.has(field.key)) {
      throw InputError(fmt::format(
          "{}: {} {}; give {} for both walls, or {} and {}", table.place(), table.named(field.key),
          of_each ? "is given twice" : "is missing", field.key, lower_key, upper_key));
    }
    if (of_each) {
      table.need(lower_key);
      table.need(upper_key);
      x.lower = number({lower_key, field.unit});
      x.upper = number({upper_key, field.unit});
      return;
    }
    constexpr const char* others = ", or [lower, upper]";
    const TomlValue both = value_of(field);
    const toml::array* array = both.node.as_array();
    if (array == nullptr) {
      x.lower = x.upper = number(field, others);
      return;
    }
    if (array->size() != 2) both.refuse("a number, or [lower, upper]");
    x.lower = number(both.entry(*array->get(0)), others);
    x.upper = number(both.entry(*array->get(1)), others);
    warn(fmt::format("{}: {} = [lower, upper] is now written as {} and {}", table.place(),
                     table.named(field.key), lower_key, upper_key));
  }

  /// A number, or an array of [time, omega].
  void operator()(const SceneField& field,
                  PlateSpeed<double, std::vector<SpeedKnot<double>>> speed) const {
    constexpr const char* others = ", or [[time, omega], ...]";
    if (!table.has(field.key)) return;
    const TomlValue given = value_of(field);
    const toml::array* array = given.node.as_array();
    if (array == nullptr) {
      speed.omega = number(field, others);
      return;
    }
    const std::string allowed = "a number" + std::string(others);
    if (array->empty()) given.refuse(allowed);
    const SceneField time{field.key, "s"};
    for (const toml::node& element : *array) {
      const toml::array* knot = element.as_array();
      if (knot == nullptr || knot->size() != 2) given.refuse(allowed);
      const double at = number_in({*knot->get(0), time, table}, others);
      speed.profile.push_back({at, number_in(given.entry(*knot->get(1)), others)});
    }
  }

  /// A number, or the word open_number, which leaves it without value.
  void operator()(const SceneField& field, std::optional<double>& x) const {
    const toml::node* node = table.find(field.key);
    if (node == nullptr) return;
    if (node->is_string() && node->as_string()->get() == open_number) {
      x.reset();
    } else {
      x = number(field, fmt::format(", or \"{}\"", open_number));
    }
  }

  template <class Choice>
  void operator()(const SceneField& field, Choice& x) const {
    FieldReader{table}(field, x);
  }
};

void read_window(const SceneReader& read, const std::string& origin, Scene& scene) {
  const bool turns = read.table.has("revolutions");
  const bool time = read.table.has("seconds");
  if (turns == time) {
    throw InputError(origin + ": window: must have one of revolutions and seconds");
  }
  if (turns) {
    scene.window = Revolutions{read.number({"revolutions", "1"})};
  } else {
    scene.window = Seconds{read.number({"seconds", "s"})};
  }
}

/// Reads path_radius, which gives centrifugal_mass_radius. If a file gives both, they must agree.
void read_path_radius(const SceneReader& read, const std::string& origin, Scene& scene) {
  if (!read.table.has(path_radius.key)) return;
  const bool both = read.table.has("centrifugal_mass_radius");
  const double radius = read.number(path_radius);
  if (!contains(path_radius.range, radius)) {
    throw InputError(fmt::format("{}: scene.path_radius = {}: must be {}", origin, radius,
                                 in_words(path_radius.range, path_radius.unit)));
  }
  const double product = scene.mass * radius;
  const double given = std::exchange(scene.centrifugal_mass_radius, product);
  if (!both) return;
  constexpr double agreement = 1e-6;
  const bool agree =
      std::abs(given - product) <= agreement * std::max(std::abs(given), std::abs(product));
  const Uncertain& uncertain = read.uncertain;
  const bool is_uncertain =
      std::any_of(uncertain.found.begin(), uncertain.found.end(),
                  [](const Uncertainty& u) { return u.key == "scene.centrifugal_mass_radius"; });
  if (uncertain.shares.empty() && (!agree || is_uncertain)) {
    throw InputError(fmt::format(
        "{}: scene.path_radius = {} and scene.centrifugal_mass_radius = {}: must agree, and mass "
        "times path_radius is {:.6g} kg m; give only one of the two",
        origin, radius, given, product));
  }
}

void refuse_unknown_tables(const toml::table& file, const std::string& origin) {
  std::vector<std::string> names;
  for (const auto& [name, keys] : scene_keys()) names.push_back(name);
  for (const auto& [key, node] : file) {
    if (std::find(names.begin(), names.end(), key.str()) == names.end() || !node.is_table()) {
      throw InputError(fmt::format("{}: {} is not a table of a scene; allowed: [{}]", origin,
                                   key.str(), fmt::join(names, "], [")));
    }
  }
}

/// Reads a scene, each uncertain number at its share.
Scene scene_of(const toml::table& file, const std::string& origin, Uncertain& uncertain) {
  refuse_unknown_tables(file, origin);
  const auto reader = [&](const std::string& name) {
    return SceneReader{TomlTable(file[name].as_table(), origin, name + "."), uncertain};
  };
  const SceneReader model = reader("model");
  const SceneReader across = reader("across");
  for (const char* needed : {"scene", "window"}) {
    if (!file.contains(needed)) {
      throw InputError(fmt::format("{}: the table [{}] is missing", origin, needed));
    }
  }
  // An unknown key is usually a mistyped one: it must be told before the missing key that it is.
  for (const auto& [name, keys] : scene_keys()) reader(name).table.refuse_others_than(keys);
  Scene result;
  visit_scene_fields(reader("scene"), result);
  read_path_radius(reader("scene"), origin, result);
  if (across.table.exists()) visit_across_fields(across, result.across.emplace());
  read_window(reader("window"), origin, result);
  visit_count_fields(reader("count"), result);
  visit_model_fields(model, result);
  if (result.contact_law == ContactLaw::kelvin_voigt && !model.table.has("contact_exponent")) {
    result.contact_exponent = 1;
  }
  check(result, origin);
  return result;
}

/// Throws InputError if an uncertain number makes no valid scene at one of its ends.
void check_ends(const toml::table& file, const std::string& origin,
                const std::vector<Uncertainty>& uncertainties) {
  std::vector<double> shares(uncertainties.size(), 0);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const Uncertainty& each = uncertainties[i];
    for (const double end : {-1.0, 1.0}) {
      shares[i] = end;
      Uncertain there{shares, {}};
      scene_of(file,
               fmt::format("{}, with {} at {} {} {}", origin, each.key, each.value,
                           end < 0 ? "-" : "+", each.plus_minus),
               there);
    }
    shares[i] = 0;
  }
}

SceneFile scene_file_of(toml::table file, std::string origin,
                        const std::vector<std::string>& settings) {
  if (toml::table* count = file["count"].as_table()) {
    rename_key(*count, "slowest", "counting_limit", origin + ": count.");
  }
  for (const std::string& setting : settings) {
    apply_setting(file, setting);
    origin += fmt::format("{} --set {}", &setting == &settings.front() ? " with" : "", setting);
  }
  Uncertain uncertain;
  Scene scene = scene_of(file, origin, uncertain);
  check_ends(file, origin, uncertain.found);
  const auto kept = std::make_shared<const toml::table>(std::move(file));
  return {std::move(scene), std::move(uncertain.found),
          [kept, origin](std::span<const double> shares) {
            Uncertain there{shares, {}};
            return scene_of(*kept, origin, there);
          }};
}

}  // namespace

SceneFile parse_scene_file(const std::string& text, const std::string& origin,
                           const std::vector<std::string>& settings) {
  return scene_file_of(parse_toml(text, origin), origin, settings);
}

Scene parse_scene(const std::string& text, const std::string& origin) {
  return parse_scene_file(text, origin).scene;
}

SceneFile read_scene_file(const std::string& path, const std::vector<std::string>& settings) {
  const bool standard_input = path == "-";
  return parse_scene_file(read_toml_text(standard_input ? "/dev/stdin" : path),
                          standard_input ? "standard input" : path, settings);
}

Scene read_scene(const std::string& path) {
  return read_scene_file(path).scene;
}

namespace {

/// Writes the fields of a table, one line each.
struct SceneWriter {
  std::string& text;

  /// Unit, allowed range and meaning.
  static std::string comment(const SceneField& field) {
    std::string text = field.unit == "1" ? "" : std::string(field.unit);
    const auto append = [&text](std::string_view separator, std::string_view part) {
      if (!part.empty()) text += fmt::format("{}{}", text.empty() ? "" : separator, part);
    };
    append(" ", field.range.brief);
    append(": ", field.remark);
    return text;
  }
  void line(const SceneField& field, std::string_view value, std::string_view comment) const {
    text += fmt::format("{} = {}{}{}\n", field.key, value, comment.empty() ? "" : "  # ", comment);
  }

  void operator()(const SceneField& field, double x) const {
    line(field, toml_float(x), comment(field));
  }
  void operator()(const SceneField& field, Walls<const double> x) const {
    if (x.lower == x.upper) return (*this)(field, x.lower);
    for (const auto& [wall, number] : {std::pair("lower", x.lower), std::pair("upper", x.upper)}) {
      const std::string key = fmt::format("{}_{}", field.key, wall);
      SceneField one = field;
      one.key = key;
      (*this)(one, number);
    }
  }
  void operator()(const SceneField& field,
                  PlateSpeed<const double, const std::vector<SpeedKnot<double>>> speed) const {
    if (speed.profile.empty()) return (*this)(field, speed.omega);
    std::vector<std::string> knots;
    for (const auto& knot : speed.profile) {
      knots.push_back(fmt::format("[{}, {}]", toml_float(knot.time), toml_float(knot.omega)));
    }
    line(field, fmt::format("[{}]", fmt::join(knots, ", ")), "s, " + comment(field));
  }
  void operator()(const SceneField& field, const std::optional<double>& x) const {
    if (x) return (*this)(field, *x);
    line(field, fmt::format("\"{}\"", open_number), "");
  }
  template <class Choice>
  void operator()(const SceneField& field, Choice x) const {
    line(field, toml_text(x), comment(field));
  }
};

}  // namespace

std::string write_scene(const Scene& scene) {
  std::string text = "[scene]\n";
  const SceneWriter write{text};
  visit_scene_fields(write, scene);
  if (scene.across) {
    text += "\n[across]  # the second direction, y\n";
    visit_across_fields(write, *scene.across);
  }
  text += "\n[window]  # revolutions or seconds\n";
  if (const auto* turns = std::get_if<Revolutions>(&scene.window)) {
    text += fmt::format("revolutions = {}\n", toml_float(turns->count));
  } else {
    text += fmt::format("seconds = {}\n", toml_float(std::get<Seconds>(scene.window).count));
  }
  text += "\n[count]\n";
  visit_count_fields(write, scene);
  text += "\n[model]\n";
  visit_model_fields(write, scene);
  return text;
}

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
