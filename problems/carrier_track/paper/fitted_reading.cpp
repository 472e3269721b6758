#include "problems/carrier_track/paper/fitted_reading.h"

#include <fmt/format.h>

#include "embedded/default_reading_text.h"
#include "problems/carrier_track/scene/toml_table.h"
#include "src/core/error.h"
#include "src/core/toml_text.h"

namespace ricochet::carrier_track::inline paper {
namespace {

/// The speed of a scene whose speed nobody has set: the quiet one of the paper's Figure 5 [rad/s].
constexpr double usual_speed = 3.0;

}  // namespace

bool is_one_scene(const Reading& reading) {
  return reading.transition == Transition::plain && reading.recovery == Recovery::restitution &&
         reading.disturbance != DisturbanceKind::acceleration;
}

FittedReading fitted_reading(const Reading& reading, const Constants& constants,
                             std::vector<Open> freed, std::string provenance,
                             const std::string& origin) {
  if (!is_one_scene(reading)) {
    throw InputError(
        fmt::format("{}: reading = {}: must be one whose cases differ in restitution, "
                    "friction and disturbance alone",
                    origin, name_of(reading)));
  }
  FittedReading fitted{reading,
                       constants,
                       std::move(freed),
                       std::move(provenance),
                       name_of(reading),
                       description_of(reading),
                       scene_of(find_case("C1"), reading, constants)};
  fitted.scene.omega = usual_speed;
  return fitted;
}

FittedReading parse_fitted_reading(const std::string& text, const std::string& origin) {
  const toml::table file = parse_toml(text, origin);
  const auto name = file["reading"].value<std::string>();
  const auto provenance = file["provenance"].value<std::string>();
  if (!name || !provenance) {
    throw InputError(origin + ": reading and provenance must be there, as texts");
  }
  const Reading reading = find_reading(*name);
  Constants constants = natural_constants();
  std::vector<Open> freed;
  TomlTable fitted(file, "fitted", origin);
  TomlTable held(file, "held", origin);
  for (const Open open : open_of(reading)) {
    const auto i = static_cast<std::size_t>(open);
    const OpenConstant& c = open_constants()[i];
    const bool is_fitted = fitted.has(c.name);
    if (is_fitted == held.has(c.name)) {
      throw InputError(fmt::format("{}: {} must be in one of [fitted] and [held]", origin, c.name));
    }
    if (is_fitted) freed.push_back(open);
    (is_fitted ? fitted : held).number(c.name, constants[i]);
    if (constants[i] < c.lower || constants[i] > c.upper) {
      throw InputError(fmt::format("{}: {} = {}: must be within {}..{} [{}]", origin, c.name,
                                   constants[i], c.lower, c.upper, c.unit));
    }
  }
  fitted.finish();
  held.finish();
  return fitted_reading(reading, constants, std::move(freed), *provenance, origin);
}

std::string write_fitted_reading(const FittedReading& fitted) {
  std::string text =
      fmt::format("reading = \"{}\"\nprovenance = \"{}\"\n", fitted.name, fitted.provenance);
  for (const bool wanted : {true, false}) {
    text += wanted ? "\n[fitted]\n" : "\n[held]\n";
    for (const Open open : open_of(fitted.reading)) {
      if (contains(fitted.freed, open) != wanted) continue;
      const auto i = static_cast<std::size_t>(open);
      text += fmt::format("{} = {}  # {}\n", open_constants()[i].name,
                          toml_float(fitted.constants[i]), open_constants()[i].unit);
    }
  }
  return text;
}

const FittedReading& default_reading() {
  static const FittedReading reading =
      parse_fitted_reading(embedded::default_reading_text, "problems/carrier_track/reading.toml");
  return reading;
}

}  // namespace ricochet::carrier_track::inline paper
