#include "problems/carrier_track/scene/scene_file.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "problems/carrier_track/scene/enum_names.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/toml_table.h"
#include "src/core/error.h"

namespace ricochet::carrier_track::inline scene {
namespace {

toml::table parse(const std::filesystem::path& path) {
  std::ifstream stream(path);
  if (std::filesystem::is_directory(path) || !stream) {
    throw InputError(fmt::format("{}: cannot be read: it must be a TOML file", path.string()));
  }
  return parse_toml(std::string(std::istreambuf_iterator<char>(stream), {}), path.string());
}

void read_scene_table(TomlTable& table, Scene& scene) {
  table.required("mass", scene.mass);
  table.required("wall_lower", scene.wall_lower);
  table.required("wall_upper", scene.wall_upper);
  table.pair("restitution", scene.restitution_lower, scene.restitution_upper);
  table.number("friction", scene.friction);
  table.number("normal_force", scene.normal_force);
  table.boolean("contact_friction", scene.contact_friction);
  table.number("pull", scene.pull);
  table.boolean("pull_rotates", scene.pull_rotates);
  table.number("pull_phase", scene.pull_phase);
  table.choice("centrifugal", centrifugal_names(), scene.centrifugal);
  table.number("centrifugal_mass_radius", scene.centrifugal_mass_radius);
  table.number("slider_mass_radius", scene.slider_mass_radius);
  table.number("phase", scene.phase);
  table.number("disturbance", scene.disturbance);
  table.number("disturbance_frequency", scene.disturbance_frequency);
  table.number("disturbance_phase", scene.disturbance_phase);
  table.required("start_position", scene.start_position);
  table.number("start_velocity", scene.start_velocity);
  table.number_or_knots("omega", scene.omega, scene.profile);
  table.finish();
}

void read_across(TomlTable& table, Scene& scene) {
  if (table.exists()) {
    Across<double>& y = scene.across.emplace();
    table.number("pull", y.pull);
    table.required("wall_lower", y.wall_lower);
    table.required("wall_upper", y.wall_upper);
    table.pair("restitution", y.restitution_lower, y.restitution_upper);
    table.required("start_position", y.start_position);
    table.number("start_velocity", y.start_velocity);
  }
  table.finish();
}

void read_window(TomlTable& table, const std::string& origin, Scene& scene) {
  double count = 0;
  const bool turns = table.has("revolutions");
  const bool time = table.has("seconds");
  table.finish();
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

void read_model(TomlTable& table, Scene& scene) {
  table.choice("fidelity", fidelity_names(), scene.fidelity);
  table.choice("contact_law", contact_law_names(), scene.contact_law);
  table.number("stiffness", scene.stiffness);
  if (scene.contact_law == ContactLaw::kelvin_voigt) scene.contact_exponent = 1;
  table.number("contact_exponent", scene.contact_exponent);
  table.number_or("contact_speed", "each", scene.contact_speed);
  table.finish();
}

std::string line_of(std::string_view key, double value, std::string_view unit) {
  return fmt::format("{} = {}  # {}\n", key, toml_float(value), unit);
}

std::string lines_of(const Across<double>& y) {
  return "\n[across]  # the second direction, y\n" +
         line_of("pull", y.pull, "N, towards wall_upper") +
         line_of("wall_lower", y.wall_lower, "m") +
         line_of("wall_upper", y.wall_upper, "m; may be inf") +
         fmt::format("restitution = [{}, {}]  # lower wall, upper wall\n",
                     toml_float(y.restitution_lower), toml_float(y.restitution_upper)) +
         line_of("start_position", y.start_position, "m") +
         line_of("start_velocity", y.start_velocity, "m/s");
}

}  // namespace

Scene read_scene(const std::filesystem::path& path) {
  const toml::table file = parse(path);
  const std::string origin = path.string();
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
  read_scene_table(scene, result);
  read_across(across, result);
  read_window(window, origin, result);
  count.choice("rule", rule_names(), result.rule);
  count.number("slowest", result.slowest);
  count.number("peak_high", result.peak_high);
  count.number("peak_low", result.peak_low);
  count.finish();
  read_model(model, result);
  check(result, origin);
  return result;
}

std::string write_scene(const Scene& scene) {
  std::string text = "[scene]\n";
  const auto line = [&text](std::string_view key, double value, std::string_view unit) {
    text += line_of(key, value, unit);
  };
  line("mass", scene.mass, "kg");
  line("wall_lower", scene.wall_lower, "m");
  line("wall_upper", scene.wall_upper, "m; may be inf");
  text += fmt::format("restitution = [{}, {}]  # lower wall, upper wall\n",
                      toml_float(scene.restitution_lower), toml_float(scene.restitution_upper));
  line("friction", scene.friction, "Coulomb coefficient");
  line("normal_force", scene.normal_force, "N, what the friction coefficient multiplies");
  text += fmt::format("contact_friction = {}  # true: and a wall's own force\n",
                      scene.contact_friction);
  line("pull", scene.pull, "N, towards wall_lower");
  text += fmt::format("pull_rotates = {}\n", scene.pull_rotates);
  line("pull_phase", scene.pull_phase, "rad, of a pull that rotates");
  text += fmt::format("centrifugal = \"{}\"  # projected, inward or outward\n",
                      name_of(centrifugal_names(), scene.centrifugal));
  line("centrifugal_mass_radius", scene.centrifugal_mass_radius, "kg m");
  line("slider_mass_radius", scene.slider_mass_radius, "kg m");
  line("phase", scene.phase, "rad");
  line("disturbance", scene.disturbance, "N");
  line("disturbance_frequency", scene.disturbance_frequency, "rad/s");
  line("disturbance_phase", scene.disturbance_phase, "rad");
  line("start_position", scene.start_position, "m");
  line("start_velocity", scene.start_velocity, "m/s");
  if (scene.profile.empty()) {
    line("omega", scene.omega, "rad/s");
  } else {
    std::string knots;
    for (const auto& knot : scene.profile) {
      knots += fmt::format("{}[{}, {}]", knots.empty() ? "" : ", ", toml_float(knot.time),
                           toml_float(knot.omega));
    }
    text += fmt::format("omega = [{}]  # s, rad/s\n", knots);
  }
  if (scene.across) text += lines_of(*scene.across);
  text += "\n[window]  # revolutions or seconds\n";
  if (const auto* turns = std::get_if<Revolutions>(&scene.window)) {
    text += fmt::format("revolutions = {}\n", toml_float(turns->count));
  } else {
    text += fmt::format("seconds = {}\n", toml_float(std::get<Seconds>(scene.window).count));
  }
  text += fmt::format("\n[count]\nrule = \"{}\"  # impacts or peaks\n",
                      name_of(rule_names(), scene.rule));
  line("slowest", scene.slowest, "m/s, rule impacts: the slowest impact that counts");
  line("peak_high", scene.peak_high, "m, rule peaks: a maximum from here on counts");
  line("peak_low", scene.peak_low, "m, rule peaks: a maximum up to here counts");
  text += fmt::format("\n[model]\nfidelity = \"{}\"\n", name_of(fidelity_names(), scene.fidelity));
  text += fmt::format("contact_law = \"{}\"\n", name_of(contact_law_names(), scene.contact_law));
  line("stiffness", scene.stiffness, "N/m^contact_exponent");
  line("contact_exponent", scene.contact_exponent, "1 for kelvin-voigt");
  text += scene.contact_speed
              ? fmt::format("contact_speed = {}  # m/s\n", toml_float(*scene.contact_speed))
              : "contact_speed = \"each\"\n";
  return text;
}

}  // namespace ricochet::carrier_track::inline scene
