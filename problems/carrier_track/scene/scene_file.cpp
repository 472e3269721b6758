#include "problems/carrier_track/scene/scene_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "problems/carrier_track/scene/enum_names.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "problems/carrier_track/scene/scene_keys.h"
#include "problems/carrier_track/scene/scene_setting.h"
#include "problems/carrier_track/scene/toml_table.h"
#include "ricochet/error.h"
#include "src/core/toml_text.h"

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

}  // namespace ricochet::carrier_track::inline scene
