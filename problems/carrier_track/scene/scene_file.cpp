#include "problems/carrier_track/scene/scene_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "problems/carrier_track/scene/toml_table.h"
#include "ricochet/error.h"
#include "ricochet/scene.h"
#include "src/core/names.h"
#include "src/core/toml.h"

namespace ricochet::carrier_track::inline scene {

namespace {

/// Reads the fields of a table, each according to its type.
struct FieldReader {
  TomlTable& table;

  void operator()(const Field& field, double& x) const {
    if (field.presence == Presence::required) table.need(field.key);
    table.number(field, x);
  }
  void operator()(const Field& field, Walls<double> x) const {
    table.walls(field, x.lower, x.upper);
  }
  void operator()(const Field& field,
                  PlateSpeed<double, std::vector<SpeedKnot<double>>> speed) const {
    table.number_or_knots(field, speed.omega, speed.profile);
  }
  void operator()(const Field& field, std::optional<double>& x) const {
    table.number_or(field, open_number, x);
  }
  void operator()(const Field& field, bool& x) const { table.boolean(field.key, x); }
  template <class Enum>
  void operator()(const Field& field, Enum& x) const {
    table.choice(field.key, names_of(x), x);
  }
};

void read_window(TomlTable& table, const std::string& origin, Scene& scene) {
  double count = 0;
  const bool turns = table.has("revolutions");
  const bool time = table.has("seconds");
  if (turns == time) {
    throw InputError(origin + ": window: must have one of revolutions and seconds");
  }
  table.number(turns ? Field{"revolutions", "1"} : Field{"seconds", "s"}, count);
  if (turns) {
    scene.window = Revolutions{count};
  } else {
    scene.window = Seconds{count};
  }
}

/// Reads path_radius, which gives centrifugal_mass_radius. If a file gives both, they must agree.
void read_path_radius(TomlTable& table, const std::string& origin, const Uncertain& uncertain,
                      Scene& scene) {
  if (!table.has(path_radius.key)) return;
  const bool both = table.has("centrifugal_mass_radius");
  double radius = 0;
  table.number(path_radius, radius);
  if (!(radius >= 0 && radius <= largest_number)) {
    throw InputError(
        fmt::format("{}: scene.path_radius = {}: must be a finite number >= 0 [m], at most 1e15",
                    origin, radius));
  }
  const double product = scene.mass * radius;
  const double given = std::exchange(scene.centrifugal_mass_radius, product);
  if (!both) return;
  constexpr double agreement = 1e-6;
  const bool agree =
      std::abs(given - product) <= agreement * std::max(std::abs(given), std::abs(product));
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
  const auto table = [&](const char* name) { return TomlTable(file, name, origin, uncertain); };
  TomlTable scene = table("scene");
  TomlTable across = table("across");
  TomlTable window = table("window");
  TomlTable count = table("count");
  TomlTable model = table("model");
  if (!scene.exists()) throw InputError(origin + ": the table [scene] is missing");
  if (!window.exists()) throw InputError(origin + ": the table [window] is missing");
  count.renamed("slowest", "counting_limit");
  // An unknown key is usually a mistyped one: it must be told before the missing key that it is.
  for (TomlTable* each : {&scene, &across, &window, &count, &model}) {
    for (const auto& [name, keys] : scene_keys()) {
      if (name == each->name()) each->refuse_others_than(keys);
    }
  }
  Scene result;
  visit_scene_fields(FieldReader{scene}, result);
  read_path_radius(scene, origin, uncertain, result);
  if (across.exists()) visit_across_fields(FieldReader{across}, result.across.emplace());
  read_window(window, origin, result);
  visit_count_fields(FieldReader{count}, result);
  visit_model_fields(FieldReader{model}, result);
  if (result.contact_law == ContactLaw::kelvin_voigt && !model.has("contact_exponent")) {
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

std::string_view range_text(Range range) {
  switch (range) {
    case Range::positive:
      return "> 0";
    case Range::not_negative:
    case Range::frequency:
      return ">= 0";
    case Range::fraction:
      return "0..1";
    case Range::any:
    case Range::finite:
    case Range::by_rule:
      return "";
  }
  return "";
}

/// Writes the fields of a table, one line each.
struct FieldWriter {
  std::string& text;

  /// Unit, allowed range and meaning.
  static std::string comment(const Field& field) {
    std::string text = field.unit == "1" ? "" : std::string(field.unit);
    const auto append = [&text](std::string_view separator, std::string_view part) {
      if (!part.empty()) text += fmt::format("{}{}", text.empty() ? "" : separator, part);
    };
    append(" ", range_text(field.range));
    append(": ", field.remark);
    return text;
  }
  void line(const Field& field, std::string_view value, std::string_view comment) const {
    text += fmt::format("{} = {}{}{}\n", field.key, value, comment.empty() ? "" : "  # ", comment);
  }

  void operator()(const Field& field, double x) const {
    line(field, toml_float(x), comment(field));
  }
  void operator()(const Field& field, Walls<const double> x) const {
    if (x.lower == x.upper) return (*this)(field, x.lower);
    for (const auto& [wall, number] : {std::pair("lower", x.lower), std::pair("upper", x.upper)}) {
      const std::string key = fmt::format("{}_{}", field.key, wall);
      Field one = field;
      one.key = key;
      (*this)(one, number);
    }
  }
  void operator()(const Field& field,
                  PlateSpeed<const double, const std::vector<SpeedKnot<double>>> speed) const {
    if (speed.profile.empty()) return (*this)(field, speed.omega);
    std::vector<std::string> knots;
    for (const auto& knot : speed.profile) {
      knots.push_back(fmt::format("[{}, {}]", toml_float(knot.time), toml_float(knot.omega)));
    }
    line(field, fmt::format("[{}]", fmt::join(knots, ", ")), "s, " + comment(field));
  }
  void operator()(const Field& field, const std::optional<double>& x) const {
    if (x) return (*this)(field, *x);
    line(field, fmt::format("\"{}\"", open_number), "");
  }
  void operator()(const Field& field, bool x) const {
    line(field, x ? "true" : "false", comment(field));
  }
  template <class Enum>
  void operator()(const Field& field, Enum x) const {
    line(field, fmt::format("\"{}\"", name_of(names_of(x), x)), comment(field));
  }
};

}  // namespace

std::string write_scene(const Scene& scene) {
  std::string text = "[scene]\n";
  const FieldWriter write{text};
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
