#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "problems/carrier_track/scene/enum_names.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "problems/carrier_track/scene/toml_table.h"
#include "ricochet/error.h"
#include "ricochet/scene.h"
#include "src/core/toml_text.h"

namespace ricochet::carrier_track::inline scene {
namespace {

const EnumNames<Centrifugal>& names_of(Centrifugal /*value*/) {
  return centrifugal_names();
}
const EnumNames<CountRule>& names_of(CountRule /*value*/) {
  return rule_names();
}
const EnumNames<Fidelity>& names_of(Fidelity /*value*/) {
  return fidelity_names();
}
const EnumNames<ContactLaw>& names_of(ContactLaw /*value*/) {
  return contact_law_names();
}

/// The word in a file instead of a number that is not given.
constexpr std::string_view open_number = "each";

/// Makes the keys of a table known.
struct KeyList {
  TomlTable& table;

  template <class Member>
  void operator()(const Field& field, const Member& /*member*/) const {
    table.know(field.key);
  }
  void operator()(const Field& field, const Walls<double>& /*member*/) const {
    table.know_walls(field.key);
  }
};

/// Reads the fields of a table, each according to its type.
struct FieldReader {
  TomlTable& table;

  void operator()(const Field& field, double& x) const {
    if (field.presence == Presence::required) table.need(field.key);
    table.number(field.key, x);
  }
  void operator()(const Field& field, Walls<double> x) const {
    table.walls(field.key, x.lower, x.upper);
  }
  void operator()(const Field& field,
                  PlateSpeed<double, std::vector<SpeedKnot<double>>> speed) const {
    table.number_or_knots(field.key, speed.omega, speed.profile);
  }
  void operator()(const Field& field, std::optional<double>& x) const {
    table.number_or(field.key, open_number, x);
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
  table.number(turns ? "revolutions" : "seconds", count);
  if (turns) {
    scene.window = Revolutions{count};
  } else {
    scene.window = Seconds{count};
  }
}

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

/// An unknown key is usually a mistyped one: it must be told before the missing key that it is.
void refuse_unknown_keys(TomlTable& scene, TomlTable& across, TomlTable& window, TomlTable& count,
                         TomlTable& model) {
  Scene any;
  visit_scene_fields(KeyList{scene}, any);
  visit_across_fields(KeyList{across}, any.across.emplace());
  window.know("revolutions");
  window.know("seconds");
  visit_count_fields(KeyList{count}, any);
  visit_model_fields(KeyList{model}, any);
  for (const TomlTable* table : {&scene, &across, &window, &count, &model}) table->finish();
}

Scene scene_of(const toml::table& file, const std::string& origin) {
  static constexpr std::array<std::string_view, 5> tables = {"scene", "across", "window", "count",
                                                             "model"};
  for (const auto& [key, node] : file) {
    if (std::find(tables.begin(), tables.end(), key.str()) == tables.end() || !node.is_table()) {
      throw InputError(fmt::format("{}: {} is not a table of a scene; allowed: [{}]", origin,
                                   key.str(), fmt::join(tables, "], [")));
    }
  }
  Scene result;
  TomlTable scene(file, "scene", origin);
  TomlTable across(file, "across", origin);
  TomlTable window(file, "window", origin);
  TomlTable count(file, "count", origin);
  TomlTable model(file, "model", origin);
  if (!scene.exists()) throw InputError(origin + ": the table [scene] is missing");
  if (!window.exists()) throw InputError(origin + ": the table [window] is missing");
  count.renamed("slowest", "counting_limit");
  refuse_unknown_keys(scene, across, window, count, model);
  visit_scene_fields(FieldReader{scene}, result);
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

}  // namespace

Scene read_scene(const std::string& path) {
  const bool standard_input = path == "-";
  return scene_of(parse_toml_file(standard_input ? "/dev/stdin" : path),
                  standard_input ? "standard input" : path);
}

Scene parse_scene(const std::string& text, const std::string& origin) {
  return scene_of(parse_toml(text, origin), origin);
}

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

}  // namespace ricochet::carrier_track::inline scene
