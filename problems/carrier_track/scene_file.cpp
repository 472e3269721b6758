#include "problems/carrier_track/scene_file.h"

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

#include "problems/carrier_track/scene_check.h"
#include "src/core/error.h"

namespace ricochet::carrier_track {
namespace {

template <class Value>
using Choices = std::vector<std::pair<std::string_view, Value>>;

const Choices<Centrifugal>& centrifugal_choices() {
  static const Choices<Centrifugal> choices = {{"projected", Centrifugal::projected},
                                               {"inward", Centrifugal::inward},
                                               {"outward", Centrifugal::outward}};
  return choices;
}

const Choices<CountRule>& rule_choices() {
  static const Choices<CountRule> choices = {{"impacts", CountRule::impacts},
                                             {"peaks", CountRule::peaks}};
  return choices;
}

template <class Value>
std::string_view name_of(const Choices<Value>& choices, Value value) {
  for (const auto& [name, choice] : choices) {
    if (choice == value) return name;
  }
  return {};
}

/// One table of the file. Every key asked for is known; finish() refuses the others.
class Table {
 public:
  Table(const toml::table& file, std::string name, std::string origin)
      : name_(std::move(name)), origin_(std::move(origin)), table_(file[name_].as_table()) {}

  bool exists() const { return table_ != nullptr; }

  bool has(std::string_view key) {
    known_.insert(std::string(key));
    return table_ != nullptr && table_->contains(key);
  }

  void number(std::string_view key, double& target) {
    if (!has(key)) return;
    target = number_of(key, *table_->get(key), "a number");
  }

  void required(std::string_view key, double& target) {
    need(key);
    number(key, target);
  }

  void need(std::string_view key) {
    if (!has(key)) {
      throw InputError(fmt::format("{}: {}.{} is missing", origin_, name_, key));
    }
  }

  /// One number for both, or an array of two.
  void pair(std::string_view key, double& first, double& second) {
    need(key);
    const toml::node& node = *table_->get(key);
    const toml::array* array = node.as_array();
    if (array == nullptr) {
      first = second = number_of(key, node, "a number, or [lower, upper]");
      return;
    }
    if (array->size() != 2) refuse(key, node, "a number, or [lower, upper]");
    first = number_of(key, *array->get(0), "a number, or [lower, upper]");
    second = number_of(key, *array->get(1), "a number, or [lower, upper]");
  }

  void boolean(std::string_view key, bool& target) {
    if (!has(key)) return;
    const toml::node& node = *table_->get(key);
    if (!node.is_boolean()) refuse(key, node, "true or false");
    target = node.as_boolean()->get();
  }

  template <class Value>
  void choice(std::string_view key, const Choices<Value>& choices, Value& target) {
    if (!has(key)) return;
    const toml::node& node = *table_->get(key);
    std::string allowed;
    for (const auto& [name, value] : choices) {
      if (node.is_string() && node.as_string()->get() == name) {
        target = value;
        return;
      }
      allowed += fmt::format("{}\"{}\"", allowed.empty() ? "" : " or ", name);
    }
    refuse(key, node, allowed);
  }

  /// A number, or a word that stands for none.
  void number_or(std::string_view key, std::string_view none, std::optional<double>& target) {
    if (!has(key)) return;
    const toml::node& node = *table_->get(key);
    if (node.is_string() && node.as_string()->get() == none) {
      target.reset();
    } else {
      target = number_of(key, node, fmt::format("a number, or \"{}\"", none));
    }
  }

  /// Refuses every key that was not asked for.
  void finish() const {
    if (table_ == nullptr) return;
    for (const auto& [key, node] : *table_) {
      if (known_.contains(std::string(key.str()))) continue;
      throw InputError(fmt::format("{}: {}.{} is not a key; allowed: {}", origin_, name_, key.str(),
                                   fmt::join(known_, ", ")));
    }
  }

 private:
  double number_of(std::string_view key, const toml::node& node, std::string_view allowed) const {
    const auto value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value) refuse(key, node, allowed);
    return *value;
  }

  [[noreturn]] void refuse(std::string_view key, const toml::node& node,
                           std::string_view allowed) const {
    std::ostringstream text;
    node.visit([&text](const auto& shown) { text << shown; });
    throw InputError(
        fmt::format("{}: {}.{} = {}: must be {}", origin_, name_, key, text.str(), allowed));
  }

  std::string name_;
  std::string origin_;
  const toml::table* table_;
  std::set<std::string> known_;
};

toml::table parse(const std::filesystem::path& path) {
  std::ifstream stream(path);
  if (std::filesystem::is_directory(path) || !stream) {
    throw InputError(fmt::format("{}: cannot be read: it must be a TOML file", path.string()));
  }
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  try {
    return toml::parse(text, path.string());
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: not valid TOML: {}", path.string(),
                                 error.source().begin.line, error.description()));
  }
}

void read_scene_table(Table& table, Scene& scene) {
  table.required("mass", scene.mass);
  table.required("wall_lower", scene.wall_lower);
  table.required("wall_upper", scene.wall_upper);
  table.pair("restitution", scene.restitution_lower, scene.restitution_upper);
  table.number("friction", scene.friction);
  table.number("normal_force", scene.normal_force);
  table.number("pull", scene.pull);
  table.boolean("pull_rotates", scene.pull_rotates);
  table.choice("centrifugal", centrifugal_choices(), scene.centrifugal);
  table.number("centrifugal_mass_radius", scene.centrifugal_mass_radius);
  table.number("slider_mass_radius", scene.slider_mass_radius);
  table.number("phase", scene.phase);
  table.number("disturbance", scene.disturbance);
  table.number("disturbance_frequency", scene.disturbance_frequency);
  table.required("start_position", scene.start_position);
  table.number("start_velocity", scene.start_velocity);
  table.number("omega", scene.omega);
  table.finish();
}

void read_window(Table& table, const std::string& origin, Scene& scene) {
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

void read_model(Table& table, Scene& scene) {
  table.choice("fidelity", fidelity_choices(), scene.fidelity);
  table.choice("contact_law", contact_law_choices(), scene.contact_law);
  table.number("stiffness", scene.stiffness);
  if (scene.contact_law == ContactLaw::kelvin_voigt) scene.contact_exponent = 1;
  table.number("contact_exponent", scene.contact_exponent);
  table.number_or("contact_speed", "each", scene.contact_speed);
  table.finish();
}

/// The shortest text that reads back to the same number, as a TOML float.
std::string text_of(double x) {
  const std::string text = fmt::format("{}", x);
  return text.find_first_of(".einf") == std::string::npos ? text + ".0" : text;
}

}  // namespace

const Choices<ContactLaw>& contact_law_choices() {
  static const Choices<ContactLaw> choices = {
      {"hertz", ContactLaw::hertz},
      {"kelvin-voigt", ContactLaw::kelvin_voigt},
      {"hunt-crossley", ContactLaw::hunt_crossley},
      {"lankarani-nikravesh", ContactLaw::lankarani_nikravesh},
      {"zhiying-qishao", ContactLaw::zhiying_qishao},
      {"flores", ContactLaw::flores},
      {"gonthier", ContactLaw::gonthier},
      {"exact-restitution", ContactLaw::exact_restitution}};
  return choices;
}

const Choices<Fidelity>& fidelity_choices() {
  static const Choices<Fidelity> choices = {{"impact", Fidelity::impact},
                                            {"compliant", Fidelity::compliant}};
  return choices;
}

Scene read_scene(const std::filesystem::path& path) {
  const toml::table file = parse(path);
  const std::string origin = path.string();
  static constexpr std::array<std::string_view, 4> tables = {"scene", "window", "count", "model"};
  for (const auto& [key, node] : file) {
    if (std::find(tables.begin(), tables.end(), key.str()) == tables.end() || !node.is_table()) {
      throw InputError(fmt::format("{}: {} is not a table of a scene; allowed: [{}]", origin,
                                   key.str(), fmt::join(tables, "], [")));
    }
  }
  Scene result;
  Table scene(file, "scene", origin);
  Table window(file, "window", origin);
  Table count(file, "count", origin);
  Table model(file, "model", origin);
  if (!scene.exists()) throw InputError(origin + ": the table [scene] is missing");
  if (!window.exists()) throw InputError(origin + ": the table [window] is missing");
  read_scene_table(scene, result);
  read_window(window, origin, result);
  count.choice("rule", rule_choices(), result.rule);
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
    text += fmt::format("{} = {}  # {}\n", key, text_of(value), unit);
  };
  line("mass", scene.mass, "kg");
  line("wall_lower", scene.wall_lower, "m");
  line("wall_upper", scene.wall_upper, "m; may be inf");
  text += fmt::format("restitution = [{}, {}]  # lower wall, upper wall\n",
                      text_of(scene.restitution_lower), text_of(scene.restitution_upper));
  line("friction", scene.friction, "Coulomb coefficient");
  line("normal_force", scene.normal_force, "N, what the friction coefficient multiplies");
  line("pull", scene.pull, "N, towards wall_lower");
  text += fmt::format("pull_rotates = {}\n", scene.pull_rotates);
  text += fmt::format("centrifugal = \"{}\"  # projected, inward or outward\n",
                      name_of(centrifugal_choices(), scene.centrifugal));
  line("centrifugal_mass_radius", scene.centrifugal_mass_radius, "kg m");
  line("slider_mass_radius", scene.slider_mass_radius, "kg m");
  line("phase", scene.phase, "rad");
  line("disturbance", scene.disturbance, "N");
  line("disturbance_frequency", scene.disturbance_frequency, "rad/s");
  line("start_position", scene.start_position, "m");
  line("start_velocity", scene.start_velocity, "m/s");
  line("omega", scene.omega, "rad/s");
  text += "\n[window]  # revolutions or seconds\n";
  if (const auto* turns = std::get_if<Revolutions>(&scene.window)) {
    text += fmt::format("revolutions = {}\n", text_of(turns->count));
  } else {
    text += fmt::format("seconds = {}\n", text_of(std::get<Seconds>(scene.window).count));
  }
  text += fmt::format("\n[count]\nrule = \"{}\"  # impacts or peaks\n",
                      name_of(rule_choices(), scene.rule));
  line("slowest", scene.slowest, "m/s, rule impacts: the slowest impact that counts");
  line("peak_high", scene.peak_high, "m, rule peaks: a maximum from here on counts");
  line("peak_low", scene.peak_low, "m, rule peaks: a maximum up to here counts");
  text +=
      fmt::format("\n[model]\nfidelity = \"{}\"\n", name_of(fidelity_choices(), scene.fidelity));
  text += fmt::format("contact_law = \"{}\"\n", name_of(contact_law_choices(), scene.contact_law));
  line("stiffness", scene.stiffness, "N/m^contact_exponent");
  line("contact_exponent", scene.contact_exponent, "1 for kelvin-voigt");
  text += scene.contact_speed
              ? fmt::format("contact_speed = {}  # m/s\n", text_of(*scene.contact_speed))
              : "contact_speed = \"each\"\n";
  return text;
}

}  // namespace ricochet::carrier_track
